// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QJsonObject>
#include <QString>

/// Drafts of lessons that nobody there could decide on when the window was closed: on the disk of the computer until
/// the program starts again.
namespace ui::study {

/// A draft, and the file of the lesson that it began from.
struct PutByDraft
{
    QString from;
    QJsonObject object;
    bool operator==(const PutByDraft&) const = default;
};

/// In the place of those that lay there: none is left where there are none. Only who runs the program may read them.
/// False: they could not be written, and what lay there does still.
[[nodiscard]] bool putBy(const QString& file, const std::vector<PutByDraft>& drafts);

/// None where nothing lies there, or something else.
[[nodiscard]] std::vector<PutByDraft> putByIn(const QString& file);

}  // namespace ui::study
