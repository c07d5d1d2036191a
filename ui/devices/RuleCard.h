// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPushButton>

#include "ui/devices/DeviceKind.h"
#include "ui/devices/NextStep.h"

class QLabel;
class QPlainTextEdit;

namespace ui::devices {

/// Explains how to let every user of the computer open the device: a udev rule to copy, and the file to put it in.
class RuleCard : public QFrame
{
    Q_OBJECT
public:
    explicit RuleCard(QWidget* parent);

    void setKind(const DeviceKind& kind);
    /// Sets whether copying the rule is the next step of the page.
    void setIsNextStep(bool isNext) { setFilled(*m_copy, isNext); }

private:
    void describe();

    DeviceKind m_kind;
    QLabel* m_words;
    QPlainTextEdit* m_rule;
    QPushButton* m_copy;
};

}  // namespace ui::devices
