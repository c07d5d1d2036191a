// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace cli {

// The subcommands of `cusp falcon` for a device.
int falconListPart(const QStringList& arguments);
int falconProbePart(const QStringList& arguments);
int falconHomePart(const QStringList& arguments);
int falconTestPart(const QStringList& arguments);
int falconRulesPart(const QStringList& arguments);
int falconCalibratePart(const QStringList& arguments);

}  // namespace cli
