// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Window.h"
#include "app/cli/Commands.h"

int main(int argc, char* argv[])
{
    if (const auto exitCode = app::cli::run(argc, argv))
        return *exitCode;
    return app::runWindow(argc, argv);
}
