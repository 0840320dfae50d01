/* apart.c - apart COMMAND...: run it in a session of its own, with signals as they
 * are by default.
 *
 * So a test is the same in a shell's background, which ignores interrupts,
 * behind nohup and without a terminal; and all of its processes, which are a
 * group, can be ended at once. */
#define _POSIX_C_SOURCE 200112L
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    if (argc < 2) return 2;
    (void)setsid();
    (void)signal(SIGHUP, SIG_DFL);
    (void)signal(SIGINT, SIG_DFL);
    (void)signal(SIGQUIT, SIG_DFL);
    (void)signal(SIGPIPE, SIG_DFL);
    (void)execvp(argv[1], argv + 1);
    perror(argv[1]);
    return 127;
}
