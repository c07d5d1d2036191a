// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QObject>

#include "core/teeth/Arch.h"

namespace ui::render {

using ArchPointer = std::shared_ptr<const core::teeth::Arch>;

/// Calls `done` with the arch: at once if it has been built, otherwise after a pool thread has built it. Does not call
/// `done` if `owner` has been destroyed. The arch is built once per run, at the first call. Ui thread.
void withArch(QObject* owner, std::function<void(const ArchPointer&)> done);

}  // namespace ui::render
