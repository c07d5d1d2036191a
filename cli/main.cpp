// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"
#include "cli/WindowCommand.h"

int main(int argc, char* argv[])
{
    if (const auto exitCode = cli::run(argc, argv))
        return *exitCode;
    return cli::runWindow(argc, argv);
}
