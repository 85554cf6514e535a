# make install, what undoes and tries it, and what is handed on.

PREFIX ?= /usr/local
bindir ?= $(PREFIX)/bin
datadir ?= $(PREFIX)/share
mandir ?= $(datadir)/man
docdir ?= $(datadir)/doc/raypro
.PHONY: install uninstall installcheck dist
# The shell's quotes around anything.
quoted = '$(subst ','\'',$(1))'
INTO = DESTDIR=$(call quoted,$(DESTDIR)) bindir=$(call quoted,$(bindir)) datadir=$(call quoted,$(datadir)) \
       mandir=$(call quoted,$(mandir)) docdir=$(call quoted,$(docdir))
install: $(PROGRAMS)
	@$(INTO) sh script/install.sh $(BUILD) $(PROGRAMS)
uninstall:
	@$(INTO) sh script/uninstall.sh
installcheck: $(PROGRAMS)
	@sh tests/fresh/install.sh $(BUILD)

# Of what is committed, with the time of the commit, nobody's name and no time in the compressed file: the same bytes
# wherever it is made.
dist:
	@git rev-parse --git-dir >/dev/null || { echo "make dist packs what is committed; this is no checkout" >&2; exit 1; }
	@mkdir -p $(BUILD)
	@git -c tar.umask=0022 archive --format=tar --prefix=raypro-$(VERSION)/ HEAD > $(BUILD)/dist.tar
	@gzip -n -9 < $(BUILD)/dist.tar > $(BUILD)/raypro-$(VERSION).tar.gz && rm -f $(BUILD)/dist.tar
	@echo $(BUILD)/raypro-$(VERSION).tar.gz
