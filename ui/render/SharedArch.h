// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QObject>

#include "core/teeth/Arch.h"

namespace ui::render {

using ArchPointer = std::shared_ptr<const core::teeth::Arch>;

/// Gives the arch to `done`: at once where it has been made before, else later, after a pool thread has made it; not
/// at all if `owner` has gone meanwhile. Ui thread. It is made once a run, when the first one asks.
void withArch(QObject* owner, std::function<void(const ArchPointer&)> done);

}  // namespace ui::render
