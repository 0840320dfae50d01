/* cortex.c - what a program on a bare Cortex-M needs: vectors, start-up, and a
 * character written by semihosting, which qemu-system-arm -semihosting does.
 * See ../reach.sh and cortex.ld. */
extern unsigned stack_top[], data_from[], data_begin[], data_end[];
extern unsigned bss_begin[], bss_end[];
int main(void);
void put(char c);
void start(void);
static void stop(void);

__attribute__((section(".vectors"), used)) static const struct {
    unsigned *stack;
    void (*handler[3])(void); /* reset, NMI, fault */
} vectors = {stack_top, {start, stop, stop}};

/* semihost - ask the debugger, which qemu is. */
static int semihost(int what, const void *about)
{
    register int r0 __asm__("r0") = what;
    register const void *r1 __asm__("r1") = about;

    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void put(char c)
{
    semihost(3, &c); /* SYS_WRITEC */
}

/* stop - a fault: leave, with a word. */
static void stop(void)
{
    semihost(4, "fault\n");                /* SYS_WRITE0 */
    semihost(0x18, (const void *)0x20023); /* SYS_EXIT, an error */
    for (;;) continue;
}

void start(void)
{
    unsigned *to, *from = data_from;

#ifdef __ARM_FP
    *(volatile unsigned *)0xe000ed88 |= 0xf << 20; /* the FPU is on */
    __asm__ volatile("dsb\n\tisb");
#endif
    for (to = data_begin; to < data_end; to++) *to = *from++;
    for (to = bss_begin; to < bss_end; to++) *to = 0;
    main();
    semihost(0x18, (const void *)0x20026); /* SYS_EXIT */
    for (;;) continue;
}
