// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QSaveFile;

namespace ui::kit {

/// Opens a file for data about people. A new file is readable by its owner only, if the file system has such
/// permissions; an existing file keeps its permissions. Returns false on failure: see QSaveFile::errorString().
[[nodiscard]] bool openForOwner(QSaveFile& file);

}  // namespace ui::kit
