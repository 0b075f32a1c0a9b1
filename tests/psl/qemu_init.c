// SPDX-License-Identifier: Apache-2.0
// The only program of a Linux system in an emulator.  It prepares devices for the suite, runs it, prints the result, and switches the computer
// off.
#define _GNU_SOURCE
#include <fcntl.h>
#include <net/if.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

static void mount_at(const char *type, const char *path)
{
    mkdir(path, 0755);
    if (mount(type, path, type, 0, NULL) != 0)
        perror(path);
}

static void console(void)
{
    int fd = open("/dev/console", O_RDWR);

    for (int i = 0; i < 3 && fd >= 0; i++)
        dup2(fd, i);
}

static void loopback(void)
{
    struct ifreq r;
    int fd = socket(AF_INET, SOCK_DGRAM, 0);

    memset(&r, 0, sizeof r);
    strcpy(r.ifr_name, "lo");
    r.ifr_flags = IFF_UP;
    if (ioctl(fd, SIOCSIFFLAGS, &r) != 0)
        perror("lo");
    close(fd);
}

static void module(const char *path)
{
    int fd = open(path, O_RDONLY);

    if (fd >= 0 && syscall(SYS_finit_module, fd, "", 0) != 0)
        perror(path);
    close(fd);
}

static int run(const char *program, const char *contract)
{
    pid_t pid = fork();
    int status = -1;

    if (pid == 0) {
        execl(program, program, contract, (char *)NULL);
        _exit(127);
    }
    waitpid(pid, &status, 0);
    return status;
}

int main(void)
{
    int failed;

    mount_at("devtmpfs", "/dev");
    console();
    mkdir("/dev/pts", 0755);
    mount_at("devpts", "/dev/pts");
    mount_at("proc", "/proc");
    mount_at("sysfs", "/sys");
    mount_at("tmpfs", P_tmpdir);
    loopback();
    module("/softdog.ko");
    setenv("PSL_PINS", "1", 1);
    failed = run("/suite", NULL) != 0;
    failed |= run("/suite-watchdog", "watchdog") != 0;
    printf("emulated Linux: %s\n", failed ? "failed" : "all well");
    fflush(stdout);
    sync();
    return reboot(RB_POWER_OFF);
}
