// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

/// The subcommands of `cusp lesson`, with the arguments after their names.
namespace cli {

int newLessonPart(const QStringList& arguments);
int previewLessonPart(const QStringList& arguments);
int captureLessonPart(const QStringList& arguments);
int packLessonsPart(const QStringList& arguments);
int unpackLessonsPart(const QStringList& arguments);

}  // namespace cli
