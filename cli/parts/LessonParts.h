// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

/// The parts of `cusp lesson`: what each does with the arguments after its name.
namespace cli {

int newLessonPart(const QStringList& arguments);
int previewLessonPart(const QStringList& arguments);
int captureLessonPart(const QStringList& arguments);
int packLessonsPart(const QStringList& arguments);
int unpackLessonsPart(const QStringList& arguments);

}  // namespace cli
