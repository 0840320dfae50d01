# make, make all   build/tess, a program that tetrahedralizes a file of points
# make run         try it: POINTS=file for points other than a mirror's sensors
# make examples    the programs of test/examples
# make pictures    write test/pictures anew
# make check       the tests
# make torture     a hunt for faults: TIME=600 seconds, SEED=1
# make certify     the same for the bounds of the search alone: TIME, SEED
# make coverage    which lines of the library the tests run (gcov)
# make mutation    which changes of it they notice: sh test/mutate.sh
# make bench       the timings; FAMILY=globe of these points alone, SIZES=all of
#                  large sets, too; test/bench.sh says more
# make paper       the experiments of the paper: test/paper/results.txt
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
TIME = 600
SEED =

COMPILE = $(CC) $(CPPFLAGS) $(CFLAGS) -I. -c -o $@
LINK = $(CC) $(CFLAGS) $(LDFLAGS) -o $@
LIBRARY = build/tess.o build/hhpred.o
EXAMPLES = interp poisson embedded surface parts stream sensor

all: build/tess

build/tess: build/driver.o build/draw.o $(LIBRARY)
	$(LINK) build/driver.o build/draw.o $(LIBRARY) $(LDLIBS)

build/tess.o: tess.c tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) tess.c

build/hhpred.o: hhpred.c hhpred.h
	@mkdir -p build
	$(COMPILE) hhpred.c

build/driver.o: test/driver.c test/draw.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/driver.c

build/draw.o: test/draw.c test/draw.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/draw.c

build/picture: test/picture.c test/draw.h build/draw.o $(LIBRARY)
	$(LINK) $(CPPFLAGS) -I. test/picture.c build/draw.o $(LIBRARY) $(LDLIBS)

build/mirror: test/mirror.c
	@mkdir -p build
	$(LINK) $(CPPFLAGS) test/mirror.c $(LDLIBS)

# The hull of the mirror's sensors fills its hole, of radius 0.6; the picture
# shall not.
run: build/tess
	@file=`basename "$(POINTS)"`; name="build/$${file%.*}"; look=; \
	case "$$file" in mirror.xyz) look="-alpha 0.5";; esac; set -x; \
	build/tess -check -vtk "$$name.vtk" -svg "$$name.svg" $$look "$(POINTS)"

examples: $(LIBRARY)
	@set -e; for name in $(EXAMPLES); do \
	echo "test/examples/$$name.c"; \
	also=; [ $$name != parts ] || also=-lpthread; \
	$(CC) $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -I. -o build/$$name \
	    test/examples/$$name.c $(LIBRARY) $(LDLIBS) $$also; \
	(cd build && ./$$name $$name.obj $$name.stl) > build/$$name.out || \
	    { cat build/$$name.out; exit 1; }; \
	cat build/$$name.out; \
	diff test/examples/$$name.out build/$$name.out; done

pictures: build/picture
	build/picture test/data/mirror.xyz test/pictures/mirror.svg \
	    test/pictures/cube.svg

check: all
	CC="$(CC)" CFLAGS="$(CFLAGS)" sh test/check.sh

torture:
	CC="$(CC)" sh test/torture.sh $(TIME) $(SEED)

certify:
	CC="$(CC)" sh test/certify.sh $(TIME) $(SEED)

coverage:
	CC="$(CC)" sh test/coverage.sh

mutation:
	CC="$(CC)" sh test/mutate.sh

bench: all
	CC="$(CC)" CFLAGS="$(CFLAGS)" FAMILY="$(FAMILY)" SIZES="$(SIZES)" \
	    SCANS="$(SCANS)" sh test/bench.sh

paper:
	CC="$(CC)" CFLAGS="$(CFLAGS)" sh test/paper/paper.sh

mirror: build/mirror
	build/mirror > test/data/mirror.xyz

clean:
	rm -rf build

help:
	@sed -n '/^#$$/q;s/^# //p' Makefile

.PHONY: all run examples pictures check torture certify coverage mutation \
    bench paper mirror clean help
