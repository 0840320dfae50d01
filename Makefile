# make            build/tess, a program that tetrahedralizes a file of points
# make run        try it: a mirror's sensors; POINTS=file for your own points,
#                 OPTIONS="-cols lon,lat,depth" for more of build/tess
# make grid       its temperatures, or POINTS' values, at a grid's places, and a
#                 section's picture
# make check      the tests, about five minutes on two processors; ONLY=cells:
#                 those of that name
# make t_tess     a test of test/unit alone; ARGS=-quick, as for t_part;
#                 brute ARGS=SETS, t_pred ARGS=PERCENT of cases
# make python     build/libtess.so, for test/bindings/python and by ctypes
# make octave     what Octave needs, by mkoctfile; then: addpath build
# make install    libtess.a, libtess.so, the headers and tess.pc, for pkg-config;
#                 PREFIX=/usr/local, LIBDIR=/usr/local/lib, DESTDIR=
# make examples   the programs of test/samples and of test/recipes/t; their
#                 times, too
# make bench      the timings: test/results/bench.txt; FAMILY=globe of these
#                 points alone, SIZES=all of large sets, too
# make clean      remove build/
#
# For those who change it:
# make check-all  more tests, all builds, machines and processes
# make torture    a hunt for faults: TIME=600 seconds, SEED=1
# make certify    the same for the bounds of the search alone: TIME, SEED
# make mutants    files with bytes changed, read under sanitizers: N=100 of
#                 them, SEED=1
# make coverage   which lines of the library the tests run (gcov)
# make bounds     proofs of the bounds on rounding errors: test/bounds
# make evidence   that, and TIME seconds of each hunt: test/results/evidence.txt
# make mutation   which changes of it they notice: N=100 changes, SEED=1;
#                 test/results/mutation.txt
# make errors     a table: errors of interpolation, linear and by slopes
# make reach      other machines and compilers: test/results/reach.txt
# make mpi        build/mesh, for processes that share nothing: test/mpi/mesh.c
# make paper      the experiments of the paper: build/paper/results.txt
# make pictures   write test/pictures anew
# make manual     write f77/README's routines anew, from f77/tess.f, hhpred.f
# make mirror     write test/data/mirror.xyz anew
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
OPTIONS =
TIME = 600
SEED =
N = 100
DESTDIR =
PREFIX = /usr/local
LIBDIR = $(PREFIX)/lib
# of a shared library that shows the public names alone
SHARED = -shared -fPIC -fvisibility=hidden -Wl,-soname,libtess.so.5 \
    -DTESS_API='__attribute__((visibility("default")))'

COMPILE = $(CC) $(CPPFLAGS) $(CFLAGS) -I. -c -o $@
LINK = $(CC) $(CFLAGS) $(LDFLAGS) -o $@
LIBRARY = build/tess.o build/hhpred.o
all: build/tess

PROGRAM = build/driver.o build/options.o build/scan.o build/cell.o \
    build/rows.o build/names.o build/doubts.o build/voids.o build/formats.o \
    build/tables.o build/meshes.o build/models.o build/atoms.o build/arrays.o \
    build/write.o build/classes.o build/shapes.o build/places.o \
    build/values.o build/validate.o build/slopes.o build/natural.o \
    build/derived.o build/cells.o \
    build/periodic.o build/draw.o build/page.o build/slice.o build/plane.o \
    build/repeat.o build/alpha.o build/level.o build/iso.o build/exact.o

build/tess: $(PROGRAM) $(LIBRARY)
	$(LINK) $(PROGRAM) $(LIBRARY) $(LDLIBS)

build/tess.o: tess.c tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) tess.c

build/hhpred.o: hhpred.c hhpred.h
	@mkdir -p build
	$(COMPILE) hhpred.c

build/driver.o: test/cli/src/driver.c test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/driver.c

build/options.o: test/cli/src/options.c test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/options.c

build/write.o: test/cli/src/write.c test/cli/src/driver.h \
    test/cli/src/draw/draw.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/write.c

build/classes.o: test/cli/src/classes.c test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/classes.c

build/places.o: test/cli/src/places.c test/cli/src/values.h \
    test/cli/src/draw/draw.h test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/places.c

build/plane.o: test/cli/src/plane.c test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/plane.c

build/repeat.o: test/cli/src/repeat.c test/cli/src/values.h \
    test/cli/src/driver.h test/recipes/recipes.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/repeat.c

build/values.o: test/cli/src/values.c test/cli/src/values.h \
    test/cli/src/driver.h test/recipes/recipes.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/values.c

build/validate.o: test/cli/src/validate.c test/cli/src/values.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/validate.c

build/level.o: test/cli/src/level.c test/cli/src/driver.h \
    test/recipes/recipes.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/level.c

# recipes
build/iso.o: test/recipes/iso.c test/recipes/recipes.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/recipes/iso.c

build/slopes.o: test/recipes/slopes.c test/recipes/recipes.h tess.h \
    hhpred.h
	@mkdir -p build
	$(COMPILE) test/recipes/slopes.c

build/natural.o: test/recipes/natural.c test/recipes/recipes.h tess.h \
    hhpred.h
	@mkdir -p build
	$(COMPILE) test/recipes/natural.c

build/derived.o: test/recipes/derived.c test/recipes/recipes.h tess.h \
    hhpred.h
	@mkdir -p build
	$(COMPILE) test/recipes/derived.c

# interpolation with the library, for other languages
FIELD = test/recipes/many.c test/recipes/slopes.c test/recipes/natural.c \
    test/recipes/derived.c tess.c hhpred.c
FIELD_H = test/recipes/recipes.h tess.h hhpred.h

python: build/libtess.so

build/libtess.so: $(FIELD) $(FIELD_H)
	@mkdir -p build
	$(LINK) $(CPPFLAGS) -I. -shared -fPIC $(FIELD) $(LDLIBS)

build/lib/libtess.a: $(LIBRARY)
	@mkdir -p build/lib
	rm -f $@
	$(AR) rc $@ $(LIBRARY)

build/lib/libtess.so.5: tess.c hhpred.c tess.h hhpred.h
	@mkdir -p build/lib
	$(LINK) $(CPPFLAGS) $(SHARED) tess.c hhpred.c $(LDLIBS)

# (what alters the library's types its callers must be told)
install: build/lib/libtess.a build/lib/libtess.so.5
	mkdir -p "$(DESTDIR)$(PREFIX)/include" "$(DESTDIR)$(LIBDIR)/pkgconfig"
	cp tess.h hhpred.h "$(DESTDIR)$(PREFIX)/include"
	cp build/lib/libtess.a build/lib/libtess.so.5 "$(DESTDIR)$(LIBDIR)"
	ln -sf libtess.so.5 "$(DESTDIR)$(LIBDIR)/libtess.so"
	@types=`echo $(CPPFLAGS) $(CFLAGS) | tr ' ' '\012' | \
	    egrep '^-DTESS_(INT=|FLOAT)' | tr '\012' ' '`; \
	awk -v prefix="$(PREFIX)" -v libdir="$(LIBDIR)" -v types="$$types" ' \
	    $$1 == "#define" && $$2 == "TESS_VERSION" { v = $$3 + 0; \
	    print "prefix=" prefix "\nincludedir=$${prefix}/include"; \
	    print "libdir=" libdir "\n\nName: tess"; \
	    print "Description: Delaunay tetrahedralization of points in space"; \
	    printf "Version: %d.%d.%d\n", v / 10000, v / 100 % 100, v % 100; \
	    print "Cflags: -I$${includedir} " types "\nLibs: -L$${libdir} -ltess"; \
	    print "Libs.private: -lm" }' tess.h \
	    > "$(DESTDIR)$(LIBDIR)/pkgconfig/tess.pc"

octave: build/tess_mex.mex
	cp test/bindings/octave/tessn.m test/bindings/octave/tessinterp.m build

build/tess_mex.mex: test/bindings/octave/tess_mex.c $(FIELD) $(FIELD_H)
	@mkdir -p build
	CC="$(CC)" CFLAGS="$(CFLAGS)" mkoctfile --mex -I. -o $@ \
	    test/bindings/octave/tess_mex.c $(FIELD)

build/scan.o: test/cli/src/read/scan.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/scan.c

build/cell.o: test/cli/src/read/cell.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/cell.c

build/rows.o: test/cli/src/read/rows.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/rows.c

build/names.o: test/cli/src/read/names.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/names.c

build/doubts.o: test/cli/src/read/doubts.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/doubts.c

build/voids.o: test/cli/src/read/voids.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/voids.c

build/tables.o: test/cli/src/read/tables.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/tables.c

build/models.o: test/cli/src/read/models.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/models.c

build/formats.o: test/cli/src/read/formats.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/formats.c

build/meshes.o: test/cli/src/read/meshes.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/meshes.c

build/atoms.o: test/cli/src/read/atoms.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/atoms.c

build/arrays.o: test/cli/src/read/arrays.c test/cli/src/read/read.h \
    test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/read/arrays.c

build/cells.o: test/recipes/cells.c test/recipes/recipes.h tess.h \
    hhpred.h
	@mkdir -p build
	$(COMPILE) test/recipes/cells.c

build/periodic.o: test/recipes/periodic.c test/recipes/recipes.h tess.h \
    hhpred.h
	@mkdir -p build
	$(COMPILE) test/recipes/periodic.c

build/shapes.o: test/cli/src/shapes.c test/cli/src/driver.h \
    test/recipes/recipes.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/shapes.c

build/alpha.o: test/cli/src/alpha.c test/cli/src/driver.h \
    test/lib/exact.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/alpha.c

build/exact.o: test/lib/exact.c test/lib/exact.h
	@mkdir -p build
	$(COMPILE) test/lib/exact.c

build/draw.o: test/cli/src/draw/draw.c test/cli/src/draw/page.h \
    test/cli/src/draw/draw.h test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/draw/draw.c

build/page.o: test/cli/src/draw/page.c test/cli/src/draw/page.h \
    test/cli/src/draw/draw.h test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/draw/page.c

build/slice.o: test/cli/src/draw/slice.c test/cli/src/draw/page.h \
    test/cli/src/draw/draw.h test/cli/src/driver.h tess.h hhpred.h
	@mkdir -p build
	$(COMPILE) test/cli/src/draw/slice.c

build/mirror: test/data/mirror.c
	@mkdir -p build
	$(LINK) $(CPPFLAGS) test/data/mirror.c $(LDLIBS)

# degrees C, metres
UNIT = `printf '\302\260C,m'`
# The hull of the mirror's sensors fills its hole, of radius 0.6; the picture
# shall not.
run: build/tess
	@file=`basename "$(POINTS)"`; look=; \
	case "$$file" in mirror.xyz) look="-alpha 0.55 -unit $(UNIT)";; \
	-) file=stdin;; esac; name="build/$$file"; set -x; \
	build/tess -check -vtk "$$name.vtk" -svg "$$name.svg" $$look $(OPTIONS) \
	    "$(POINTS)"

grid: build/tess
	@file=`basename "$(POINTS)"`; look=; name="build/$$file.grid"; \
	case "$$file" in mirror.xyz) look="-alpha 0.55 -unit $(UNIT)"; \
	name=build/mirror;; esac; look="-q -method smooth $$look"; set -ex; \
	build/tess $$look -grid 200,200,20 -values "$$name.vtk" $(OPTIONS) \
	    "$(POINTS)"; \
	build/tess $$look -grid 400,1,120 -values "$$name.svg" $(OPTIONS) \
	    "$(POINTS)"

# a sample, or a recipe's test, names the files that it is linked from, and
# libraries, in its first comment
examples: $(LIBRARY)
	@set -e; for file in `grep -l '^int main' test/samples/*.c \
	    test/recipes/t/*.c`; do \
	echo "$$file"; \
	name=`basename $$file .c`; \
	case $$name in calls_fortran) continue;; esac; \
	with=`sed '/\*\/$$/q' $$file | tr ' ' '\012' | \
	    egrep '^test/(recipes|samples)/[a-z_/]*[.]c$$|^-l' | sort -ru`; \
	$(CC) $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -I. -o build/$$name $(LIBRARY) \
	    $$with $(LDLIBS); \
	(cd build && ./$$name $$name.obj $$name.stl) < test/data/mirror.xyz \
	    > build/$$name.out || \
	    { cat build/$$name.out; exit 1; }; \
	cat build/$$name.out; \
	diff $${file%.c}.out build/$$name.out; done

pictures: build/tess
	sh test/pictures/pictures.sh
	@python=$${PYTHON:-python3}; \
	if $$python -c 'import matplotlib' 2> build/pictures/words; then set -x; \
	$$python test/pictures/speed.py test/results/bench.txt \
	    test/pictures/speed.svg; else \
	echo "no matplotlib for $$python: test/pictures/speed.svg is as it was"; fi

errors: $(LIBRARY)
	$(CC) $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -o build/slopes -I. \
	    test/recipes/slopes.c test/recipes/t/t_slopes.c $(LIBRARY) $(LDLIBS)
	build/slopes table

CHECK = CC="$(CC)" CFLAGS="$(CFLAGS)" ONLY="$(ONLY)" \
    COMPLETE="$(COMPLETE)" sh test/check.sh
MADE = MADE="$(CPPFLAGS)$(CC) $(CFLAGS)"
check: all
	$(MADE) $(CHECK)

check-all: all
	$(MADE) $(CHECK) -all

UNITS = brute t_cells t_check t_facet t_locate t_natural t_part t_pred t_query \
    t_range t_resume t_size t_tess
$(UNITS):
	@$(CHECK) -unit $@ $(ARGS)

t_index:
	@$(CHECK) -unit $@ write build/index
	@$(CHECK) -unit $@ build/index

torture:
	CC="$(CC)" sh test/fuzz/torture.sh $(TIME) $(SEED)

mutants: build/tess
	CC="$(CC)" $${PYTHON:-python3} test/fuzz/bytes.py $(N) $(SEED)

certify:
	CC="$(CC)" sh test/fuzz/certify.sh $(TIME) $(SEED)

coverage:
	CC="$(CC)" sh test/fuzz/coverage.sh

bounds:
	CC="$(CC)" sh test/bounds/bounds.sh

evidence:
	CC="$(CC)" sh test/fuzz/evidence.sh $(TIME) $(SEED)

mutation:
	CC="$(CC)" sh test/fuzz/mutation.sh $(N) $(SEED)

bench: all
	CC="$(CC)" CFLAGS="$(CFLAGS)" FAMILY="$(FAMILY)" SIZES="$(SIZES)" \
	    SCANS="$(SCANS)" sh test/bench/bench.sh

MESH = test/mpi/mesh.c test/mpi/split.c test/mpi/halo.c test/mpi/stars.c \
    test/mpi/output.c test/mpi/mail.c

mpi: build/mesh build/same

build/mesh: $(MESH) test/mpi/mesh.h test/lib/points.c test/lib/points.h \
    test/lib/measured.h $(LIBRARY)
	OMPI_CC="$(CC)" mpicc $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -o $@ $(MESH) \
	    test/lib/points.c $(LIBRARY) $(LDLIBS)

build/same: test/mpi/same.c test/lib/points.c test/lib/points.h \
    test/lib/measured.h $(LIBRARY)
	$(LINK) $(CPPFLAGS) test/mpi/same.c test/lib/points.c $(LIBRARY) $(LDLIBS)

paper:
	CC="$(CC)" CFLAGS="$(CFLAGS)" sh test/paper/paper.sh

reach:
	CC="$(CC)" sh test/builds/machines/reach.sh

manual:
	@mkdir -p build
	sh test/twin/manual.sh > build/manual
	cp build/manual f77/README

mirror: build/mirror
	build/mirror > test/data/mirror.xyz

clean:
	rm -rf build test/bindings/python/build test/bindings/python/*.egg-info \
	    test/bindings/python/tess89/_library.*

help:
	@sed -n '/^[^#]/q;s/^# \{0,1\}//p' Makefile

.PHONY: all run grid examples python octave install pictures errors check \
    check-all $(UNITS) t_index torture certify mutants coverage evidence \
    mutation bounds bench mpi paper reach manual mirror clean help
