// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/DrillSwitch.h"

#include <QAction>
#include <QPainter>

#include "ui/kit/Actions.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::practice {

DrillSwitch::DrillSwitch(QAction* action, QWidget* parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setChecked(action->isChecked());
    kit::followWords(action, this, [this, action] {
        setText(action->text());
        setToolTip(action->toolTip());
        setStatusTip(action->statusTip());
        setAccessibleDescription(action->toolTip());
        m_key = action->shortcut().toString(QKeySequence::NativeText);
    });
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const auto name = [this, action] {
        setAccessibleName(action->isChecked() ? tr("Drill is on") : tr("Drill is off"));
    };
    text::bindTranslation(this, name);
    connect(this, &QAbstractButton::clicked, action, [this, action] {
        action->trigger();
        setChecked(action->isChecked());
    });
    connect(action, &QAction::toggled, this, &QAbstractButton::setChecked);
    connect(action, &QAction::toggled, this, name);
    connect(action, &QAction::enabledChanged, this, &QAbstractButton::setEnabled);
}

void DrillSwitch::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& p = palette();
    const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
    const bool on = isChecked();
    painter.setPen(on ? Qt::NoPen : QPen(p.color(QPalette::Mid), 1));
    painter.setBrush(on ? p.color(QPalette::Highlight) : p.color(underMouse() ? QPalette::Midlight : QPalette::Base));
    painter.drawRoundedRect(frame, kit::kRadius, kit::kRadius);
    if (hasFocus()) {
        painter.setPen(QPen(p.color(QPalette::WindowText), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(frame, kit::kRadius, kit::kRadius);
    }
    painter.setOpacity(isEnabled() ? 1.0 : 0.38);
    const QColor words = p.color(on ? QPalette::HighlightedText : QPalette::WindowText);

    // A lamp: a full disc when on, a ring when off.
    painter.setPen(QPen(on ? words : p.color(QPalette::PlaceholderText), 2));
    painter.setBrush(on ? QBrush(words) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QPointF(kit::kSpace4 + 5, height() / 2.0), 5, 5);

    painter.setPen(words);
    painter.setFont(kit::typeface(kit::kTitle, QFont::DemiBold));
    painter.drawText(QRect(kit::kSpace4 + 22, 0, width() - 90, height()), Qt::AlignVCenter | Qt::AlignLeft,
                     on ? tr("Drill on") : tr("Drill off"));
    const QRectF cap(width() - kit::kSpace4 - 24.0, height() / 2.0 - 12.0, 24, 24);
    painter.setPen(QPen(on ? words : p.color(QPalette::Mid), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(cap, 4, 4);
    painter.setPen(on ? words : p.color(QPalette::PlaceholderText));
    painter.setFont(kit::typeface(kit::kSmall, QFont::Medium));
    painter.drawText(cap, Qt::AlignCenter, m_key);
}

}  // namespace ui::practice
