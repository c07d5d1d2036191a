// SPDX-License-Identifier: GPL-3.0-or-later
#include <pwd.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <new>

#include <QtGlobal>

#include "cli/Commands.h"
#include "cli/WindowCommand.h"

namespace {

/// Sets HOME to the account's home folder where the environment has none, as for a service. Otherwise Qt would look for
/// the user's files in "/".
void setHome()
{
    if (!qEnvironmentVariableIsEmpty("HOME"))
        return;
    const passwd* const account = getpwuid(geteuid());
    if (account != nullptr && account->pw_dir != nullptr && *account->pw_dir != '\0')
        qputenv("HOME", account->pw_dir);
    else
        std::fputs("cusp: HOME is not set and this account has no home folder; set HOME to keep files in it.\n",
                   stderr);
}

/// Keeps a crash from writing the memory of the program, which holds passwords, into a file.
void forbidCoreDump()
{
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
}

}  // namespace

int main(int argc, char* argv[])
{
    forbidCoreDump();
    setHome();
    try {
        if (const auto exitCode = cli::run(argc, argv))
            return *exitCode;
    } catch (const std::bad_alloc&) {
        std::fputs("cusp: there is not enough memory for this; close other programs, or take a smaller file.\n",
                   stderr);
        return 1;
    }
    return cli::runWindow(argc, argv);
}
