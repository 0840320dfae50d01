# make, make all   build/tess, a program that tetrahedralizes a file of points
# make run         try it: POINTS=file for points other than a mirror's sensors
# make check       the tests
# make bench       the timings
# make mirror      write test/data/mirror.xyz anew
# make clean       remove build/
# make help        this list
#
# To use the library copy tess.c tess.h hhpred.c hhpred.h; it needs no make.
# After changing flags: make clean.  Example: make CC=clang CFLAGS=-O2
.POSIX:

CC = cc
CFLAGS = -O3
CPPFLAGS =
LDFLAGS =
LDLIBS = -lm
POINTS = test/data/mirror.xyz

COMPILE = $(CC) $(CPPFLAGS) $(CFLAGS) -I. -c -o $@
LINK = $(CC) $(CFLAGS) $(LDFLAGS) -o $@
LIBRARY = build/tess.o build/hhpred.o

all: build/tess

build/tess: build/driver.o $(LIBRARY)
	$(LINK) build/driver.o $(LIBRARY) $(LDLIBS)

build/tess.o: tess.c tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) tess.c

build/hhpred.o: hhpred.c hhpred.h
	@mkdir -p build
	$(COMPILE) hhpred.c

build/driver.o: test/driver.c tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/driver.c

build/mirror: test/mirror.c
	@mkdir -p build
	$(LINK) $(CPPFLAGS) test/mirror.c $(LDLIBS)

run: build/tess
	@file=`basename "$(POINTS)"`; set -x; \
	build/tess -check -vtk "build/$${file%.*}.vtk" "$(POINTS)"

check: all
	CC="$(CC)" CFLAGS="$(CFLAGS)" sh test/check.sh

bench: all
	CC="$(CC)" CFLAGS="$(CFLAGS)" sh test/bench.sh

mirror: build/mirror
	build/mirror > test/data/mirror.xyz

clean:
	rm -rf build

help:
	@sed -n '/^#$$/q;s/^# //p' Makefile

.PHONY: all run check bench mirror clean help
