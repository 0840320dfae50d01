# shellcheck shell=sh
# shellcheck disable=SC2034,SC2154 # of check.sh, which reads this
# machines.sh - other machines, simulated.

# ---- the same results on other machines, simulated ----

# cross COMPILER EMULATOR MACHINE [N]: of sets of at most N points, where an
# emulator takes a hundred times as long
cross() {
    name="same result: $3"
    wanted "$name" || return
    if command -v $1 > /dev/null && command -v $2 > /dev/null; then
        if build cross $1 "-O2 -static" test/twin/parity.c $LIBRARY; then
            # (ONLY may have left it out)
            [ -x build/parity ] ||
                build parity "$CC" -O1 test/twin/parity.c $LIBRARY
            $2 build/cross $4 > build/cross.txt 2>> $LOG
            build/parity $4 > build/here.txt 2>> $LOG
            check "$name" diff build/here.txt build/cross.txt
        else
            fail "$name: does not compile"
        fi
    else
        skip "$name: no $1 with $2"
    fi
}

# avr NAME FLAGS FILE: compile for an ATmega1284P, and run; what it writes to
# build/avr.txt
avr() {
    wanted "$1" || return
    if ! build avr.elf avr-gcc "-std=gnu89 -mmcu=atmega1284p $2" $3 $LIBRARY
    then
        fail "$1: does not compile"
        return 1
    fi
    limited 100 simavr -m atmega1284p -f 16000000 build/avr.elf 2>&1 |
        sed -n 's/[^ -~]\[[0-9]*m//g; s/\.$//p' > build/avr.txt
}

machines() {
    # (larger sets in such arithmetic: `same', t_pred)
    cross powerpc64-linux-gnu-gcc qemu-ppc64 "big-endian (PowerPC)" 401
    cross arm-linux-gnueabihf-gcc qemu-arm "32-bit ARM" 401
    cross i686-linux-gnu-gcc qemu-i386 "x87" 401
    cross m68k-linux-gnu-gcc qemu-m68k "big-endian with an 80-bit unit (68k)" \
        401
    # WebAssembly, without a C library but for what run.js has
    if command -v wasm-ld > /dev/null && command -v node > /dev/null &&
        command -v clang > /dev/null; then
        for d in -DTESS_FLOAT ""; do
            # shellcheck disable=SC2086 # lists of flags, of files
            check "same result: wasm32 $d" sh -c "$CC -O2 $d -o build/tiny \
                test/builds/machines/tiny.c $LIBRARY $LIBS &&
                build/tiny > build/tiny.txt &&
                $WASM $d -o build/tiny.wasm test/builds/machines/tiny.c \
                    $LIBRARY &&
                node test/builds/machines/wasm/run.js build/tiny.wasm |
                    cmp - build/tiny.txt"
        done
    else
        skip "wasm32: no clang with wasm-ld (lld) and node"
    fi
    # int of 16 bits and double of 24, in 16 kilobytes of memory: once indices of
    # 16 bits and -Os, once of 32 bits and -O2.  (A difference may be the
    # simulator's: simavr 1.6 takes an adiw or sbiw by 12 to 15, modulo 16, that
    # is to be skipped for two words.)
    if ! command -v avr-gcc > /dev/null || ! command -v simavr > /dev/null; then
        skip "AVR: no avr-gcc with simavr"
        return
    fi
    build tiny "$CC" "-O2 -DTESS_FLOAT" test/builds/machines/tiny.c $LIBRARY &&
        build/tiny > build/tiny.txt
    # each line begins with the code 0
    check "same result: AVR: 4 sets" test \
        "$(grep -c '^0 1 0' build/tiny.txt)" -eq 4
    avr "same result: AVR" "-Os -DTESS_INT=short -DTESS_LIST=64" \
        test/builds/machines/tiny.c &&
        check "same result: AVR" cmp build/tiny.txt build/avr.txt
    avr "example: sensor, AVR" "-O2 -DTESS_LIST=64 -ffunction-sections \
        -Wl,--gc-sections -I." test/samples/sensor.c &&
        check "example: sensor, AVR" cmp test/samples/sensor.out build/avr.txt
}
