# Where make install puts things; read by install.sh and uninstall.sh, never run.
absolute() { case "$1" in /*) printf '%s\n' "$1" ;; *) printf '%s\n' "$PWD/$1" ;; esac; }
DESTDIR=${DESTDIR-}
bindir=$(absolute "$bindir")
datadir=$(absolute "$datadir")
mandir=$(absolute "$mandir")
docdir=$(absolute "$docdir")
installed=$datadir/raypro/installed.txt
