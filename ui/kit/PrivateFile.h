// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QSaveFile;

namespace ui::kit {

/// Opens a file that something about people is saved into: one that is new only its owner may read, where the file
/// system knows such rights; of one that is there it stays who may. False: see QSaveFile::errorString().
[[nodiscard]] bool openForOwner(QSaveFile& file);

}  // namespace ui::kit
