#!/bin/sh
# Writes files that are found under the names of meshes and are none. Needs binutils, iconv, gzip, bzip2, xz and python3.
set -eu
cd "$(dirname "$0")"
echo '.globl box; box: ret' | as -o elf.o
objcopy -I elf64-x86-64 -O pe-x86-64 --strip-unneeded elf.o coff.o
echo '.globl box; box: ret' | as --32 -o elf32.o
objcopy -I elf32-i386 -O pe-i386 --strip-unneeded elf32.o coff32.o
ar rcD library.a elf.o
triangle='v 0 0 0
v 1 0 0
v 0 1 0
f 1 2 3'
echo "$triangle" | iconv -t UTF-16 > utf16
echo "$triangle" | iconv -t UTF-16LE > utf16le
echo "$triangle" | iconv -t UTF-16BE > utf16be
echo "$triangle" | gzip -n > mesh.gz
echo "$triangle" | bzip2 > mesh.bz2
echo "$triangle" | xz > mesh.xz
python3 -c "
import zipfile
with zipfile.ZipFile('mesh.zip', 'w') as archive:
    archive.writestr(zipfile.ZipInfo('mesh.obj'), 'v 0 0 0')
"
printf 'version https://git-lfs.github.com/spec/v1\noid sha256:%064d\nsize 1234\n' 0 > lfs
printf '\n<!DOCTYPE html>\n<html>\n<head><title>Not Found</title></head>\n<body>\np { }\n</body></html>\n' > page
printf '<?xml version="1.0" encoding="utf-8"?>\n<COLLADA version="1.4.1"/>\n' > collada
printf '{"message": "Not Found"}\n' > json
