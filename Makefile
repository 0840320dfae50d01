# make            build/tess, a program that tetrahedralizes a file of points
# make run        try it: a mirror's sensors; POINTS=file for your own points,
#                 OPTIONS="-cols lon,lat,depth" for more of build/tess
# make grid       its temperatures, or POINTS' values, at a grid's places, and a
#                 section's picture
# make check      the tests, about four minutes on two processors; ONLY=cells:
#                 those of that name; COMPLETE=yes: a tool that is missing is a
#                 failure
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
# make release    what a release asks for: figures of this very code, and all of
#                 check-all, with no tool missing
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
# make data       write test/data's files anew
#
# To use the library copy tess.c tess.h hhpred.c hhpred.h; it needs no make.
# After changing flags: make clean.  Example: make CC=clang CFLAGS=-O2
# Sources that are to stay as they are, or read-only: make BUILD=../objects writes
# all there; make check, and what else runs scripts, to ../objects/tree/build.
.POSIX:

CC = cc
CFLAGS = -O3
CPPFLAGS =
LDFLAGS =
LDLIBS = -lm
BUILD = build
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
LIBRARY = $(BUILD)/tess.o $(BUILD)/hhpred.o
all: $(BUILD)/tess

PROGRAM = build/driver.o build/options.o build/scan.o build/cell.o \
    build/rows.o build/names.o build/doubts.o build/voids.o build/formats.o \
    build/tables.o build/meshes.o build/models.o build/atoms.o \
    build/arrays.o build/write.o build/classes.o build/shapes.o \
    build/places.o build/values.o build/validate.o build/slopes.o \
    build/natural.o build/derived.o build/cells.o build/periodic.o \
    build/draw.o build/page.o build/slice.o build/plane.o build/repeat.o \
    build/alpha.o build/level.o build/iso.o build/exact.o

OBJECTS = $(PROGRAM:build/%=$(BUILD)/%) $(LIBRARY)

$(BUILD)/tess: $(OBJECTS)
	$(LINK) $(OBJECTS) $(LDLIBS)

# An object's source is the file of its name in one of these places.
SOURCES = *.c test/cli/src/*.c test/cli/src/*/*.c test/recipes/*.c test/lib/*.c
$(OBJECTS): Makefile
	@mkdir -p $(BUILD)
	@for from in $(SOURCES); do \
	if test "`basename $$from .c`" = `basename $@ .o`; then \
	echo '$(COMPILE)' $$from; $(COMPILE) $$from && $(TELL); exit; fi; done

# What $@ is made of, $$from, includes these headers, as the compiler says; where
# it cannot, all.
HEADERS = *.h test/*/*.h test/*/*/*.h test/*/*/*/*.h
TELL = { $(CC) $(CPPFLAGS) $(CFLAGS) -I. -MM -MP -MT $@ $$from > $@.d \
    2> $(BUILD)/told || { echo $@: $$from $(HEADERS); \
    printf '%s:\n' $(HEADERS); } > $@.d; }
-include $(OBJECTS:.o=.o.d)
-include $(BUILD)/libtess.so.d $(BUILD)/lib/libtess.so.5.d
-include $(BUILD)/tess_mex.mex.d $(BUILD)/mesh.d $(BUILD)/same.d

# interpolation with the library, for other languages
FIELD = test/recipes/many.c test/recipes/slopes.c test/recipes/natural.c \
    test/recipes/derived.c tess.c hhpred.c

python: $(BUILD)/libtess.so

$(BUILD)/libtess.so: $(FIELD) test/recipes/iso.c Makefile
	@mkdir -p $(BUILD)
	$(LINK) $(CPPFLAGS) -I. -shared -fPIC $(FIELD) test/recipes/iso.c $(LDLIBS)
	@from="$(FIELD) test/recipes/iso.c"; $(TELL)

$(BUILD)/lib/libtess.a: $(LIBRARY)
	@mkdir -p $(BUILD)/lib
	rm -f $@
	$(AR) rc $@ $(LIBRARY)

$(BUILD)/lib/libtess.so.5: tess.c hhpred.c Makefile
	@mkdir -p $(BUILD)/lib
	$(LINK) $(CPPFLAGS) $(SHARED) tess.c hhpred.c $(LDLIBS)
	@from="tess.c hhpred.c"; $(TELL)

# (what alters the library's types its callers must be told)
install: $(BUILD)/lib/libtess.a $(BUILD)/lib/libtess.so.5
	mkdir -p "$(DESTDIR)$(PREFIX)/include" "$(DESTDIR)$(LIBDIR)/pkgconfig"
	cp tess.h hhpred.h "$(DESTDIR)$(PREFIX)/include"
	cp $(BUILD)/lib/libtess.a $(BUILD)/lib/libtess.so.5 "$(DESTDIR)$(LIBDIR)"
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

octave: $(BUILD)/tess_mex.mex
	cp test/bindings/octave/tessn.m test/bindings/octave/tessinterp.m $(BUILD)

$(BUILD)/tess_mex.mex: test/bindings/octave/tess_mex.c $(FIELD) Makefile
	@mkdir -p $(BUILD)
	CC="$(CC)" CFLAGS="$(CFLAGS)" mkoctfile --mex -I. -o $@ \
	    test/bindings/octave/tess_mex.c $(FIELD)
	@from="test/bindings/octave/tess_mex.c $(FIELD)"; $(TELL)

$(BUILD)/mirror: test/data/mirror.c
	@mkdir -p $(BUILD)
	$(LINK) $(CPPFLAGS) test/data/mirror.c $(LDLIBS)

$(BUILD)/holes: test/data/holes.c
	@mkdir -p $(BUILD)
	$(LINK) $(CPPFLAGS) test/data/holes.c

# Scripts write to build/, where they run: with another BUILD in a directory of
# links to the sources.
AT = test "$(BUILD)" = build || { mkdir -p "$(BUILD)/tree/build"; \
    for f in * .[a-z]*; do case $$f in build | .git) ;; \
    *) test -h "$(BUILD)/tree/$$f" || ln -s "`pwd`/$$f" "$(BUILD)/tree";; esac; \
    done; for f in tess tess.o hhpred.o; do test ! -f "$(BUILD)/$$f" || \
    cp "$(BUILD)/$$f" "$(BUILD)/tree/build"; done; cd "$(BUILD)/tree" || exit; };

# degrees C, metres
UNIT = `printf '\302\260C,m'`
# The hull of the mirror's sensors fills its hole, of radius 0.6; the picture
# shall not.
run: $(BUILD)/tess
	@file=`basename "$(POINTS)"`; look=; \
	case "$$file" in mirror.xyz) look="-alpha 0.55 -unit $(UNIT)";; \
	-) file=stdin;; esac; name="$(BUILD)/$$file"; set -x; \
	$(BUILD)/tess -check -vtk "$$name.vtk" -svg "$$name.svg" $$look $(OPTIONS) \
	    "$(POINTS)"

grid: $(BUILD)/tess
	@file=`basename "$(POINTS)"`; look=; name="$(BUILD)/$$file.grid"; \
	case "$$file" in mirror.xyz) look="-alpha 0.55 -unit $(UNIT)"; \
	name=$(BUILD)/mirror;; esac; look="-q -method smooth $$look"; set -ex; \
	$(BUILD)/tess $$look -grid 200,200,20 -values "$$name.vtk" $(OPTIONS) \
	    "$(POINTS)"; \
	$(BUILD)/tess $$look -grid 400,1,120 -values "$$name.svg" $(OPTIONS) \
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
	$(CC) $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -I. -o $(BUILD)/$$name $(LIBRARY) \
	    $$with $(LDLIBS); \
	(cd $(BUILD) && ./$$name $$name.obj $$name.stl) < test/data/mirror.xyz \
	    > $(BUILD)/$$name.out || \
	    { cat $(BUILD)/$$name.out; exit 1; }; \
	cat $(BUILD)/$$name.out; \
	diff $${file%.c}.out $(BUILD)/$$name.out; done

pictures: all
	@$(AT) sh test/pictures/pictures.sh && \
	python=$${PYTHON:-python3}; \
	if $$python -c 'import matplotlib' 2> build/pictures/words; then set -x; \
	$$python test/pictures/speed.py test/results/bench.txt \
	    test/pictures/speed.svg; else \
	echo "no matplotlib for $$python: test/pictures/speed.svg is as it was"; fi

errors: $(LIBRARY)
	$(CC) $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -o $(BUILD)/slopes -I. \
	    test/recipes/slopes.c test/recipes/t/t_slopes.c $(LIBRARY) $(LDLIBS)
	$(BUILD)/slopes table

CHECK = CC="$(CC)" CFLAGS="$(CFLAGS)" ONLY="$(ONLY)" \
    COMPLETE="$(COMPLETE)" sh test/check.sh
MADE = MADE="$(CPPFLAGS)$(CC) $(CFLAGS)"
# (before tests, which take all processors, two compilers at a time, unless make
# has been told how many)
TWO = `case "$$MAKEFLAGS" in *-j*) ;; *) echo -j2;; esac`
check:
	@$(MAKE) $(TWO) all
	@sh test/bench/stamps.sh || :
	@$(AT) $(MADE) $(CHECK)

check-all:
	@$(MAKE) $(TWO) all
	@$(AT) $(MADE) $(CHECK) -all

release: all
	@sh test/bench/stamps.sh
	@$(MAKE) check-all COMPLETE=yes

UNITS = brute t_cells t_check t_facet t_locate t_natural t_part t_pred t_query \
    t_range t_resume t_size t_tess
$(UNITS):
	@$(AT) $(CHECK) -unit $@ $(ARGS)

t_index:
	@$(AT) $(CHECK) -unit $@ write build/index
	@$(AT) $(CHECK) -unit $@ build/index

torture:
	@$(AT) CC="$(CC)" sh test/fuzz/torture.sh $(TIME) $(SEED)

mutants: all
	@$(AT) CC="$(CC)" $${PYTHON:-python3} test/fuzz/bytes.py $(N) $(SEED)

certify:
	@$(AT) CC="$(CC)" sh test/fuzz/certify.sh $(TIME) $(SEED)

coverage:
	@$(AT) CC="$(CC)" sh test/fuzz/coverage.sh

bounds:
	@$(AT) CC="$(CC)" sh test/bounds/bounds.sh

evidence:
	@$(AT) CC="$(CC)" sh test/fuzz/evidence.sh $(TIME) $(SEED)

mutation:
	@$(AT) CC="$(CC)" sh test/fuzz/mutation.sh $(N) $(SEED)

bench: all
	@$(AT) CC="$(CC)" CFLAGS="$(CFLAGS)" FAMILY="$(FAMILY)" SIZES="$(SIZES)" \
	    SCANS="$(SCANS)" sh test/bench/bench.sh

MESH = test/mpi/mesh.c test/mpi/split.c test/mpi/halo.c test/mpi/stars.c \
    test/mpi/output.c test/mpi/mail.c

mpi: $(BUILD)/mesh $(BUILD)/same

$(BUILD)/mesh: $(MESH) test/lib/points.c $(LIBRARY)
	OMPI_CC="$(CC)" mpicc $(CPPFLAGS) $(CFLAGS) $(LDFLAGS) -o $@ $(MESH) \
	    test/lib/points.c $(LIBRARY) $(LDLIBS)
	@from="$(MESH) test/lib/points.c"; $(TELL)

$(BUILD)/same: test/mpi/same.c test/lib/points.c $(LIBRARY)
	$(LINK) $(CPPFLAGS) test/mpi/same.c test/lib/points.c $(LIBRARY) $(LDLIBS)
	@from="test/mpi/same.c test/lib/points.c"; $(TELL)

paper:
	@$(AT) CC="$(CC)" CFLAGS="$(CFLAGS)" sh test/paper/paper.sh

reach:
	@$(AT) CC="$(CC)" sh test/builds/machines/reach.sh

manual:
	@mkdir -p $(BUILD)
	sh test/twin/manual.sh > $(BUILD)/manual
	cp $(BUILD)/manual f77/README

data: $(BUILD)/mirror $(BUILD)/holes
	$(BUILD)/mirror > test/data/mirror.xyz
	$(BUILD)/holes > test/data/holes.csv

clean:
	rm -rf $(BUILD) test/bindings/python/build test/bindings/python/*.egg-info \
	    test/bindings/python/tess89/_library.*

help:
	@sed -n '/^[^#]/q;s/^# \{0,1\}//p' Makefile

.PHONY: all run grid examples python octave install pictures errors check \
    check-all release $(UNITS) t_index torture certify mutants coverage evidence \
    mutation bounds bench mpi paper reach manual data clean help
