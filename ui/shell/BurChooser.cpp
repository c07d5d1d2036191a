// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/BurChooser.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>

#include "ui/shell/Actions.h"
#include "ui/shell/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::shell {
namespace {

constexpr double kPxPerMm = 11.0;
/// How much of the shank is drawn above the longest head, mm.
constexpr double kTopMm = 4.4;

/// Both halves of the head, tip at the origin, y upwards negative.
QPainterPath headOf(const core::drilling::Bur& bur)
{
    QPainterPath path;
    path.moveTo(0, 0);
    for (const auto& p : bur.outline)
        path.lineTo(p.radiusMm, -p.heightMm);
    for (auto p = bur.outline.rbegin(); p != bur.outline.rend(); ++p)
        path.lineTo(-p->radiusMm, -p->heightMm);
    path.closeSubpath();
    return path;
}

}  // namespace

BurTile::BurTile(const core::drilling::Bur& bur, QAction* action, QWidget* parent) : QAbstractButton(parent), m_bur(bur)
{
    setCheckable(true);
    setChecked(action->isChecked());
    setEnabled(action->isEnabled());
    followWords(action, this, [this, action] {
        setText(action->text());
        setToolTip(
            Actions::isRefused(action)
                ? action->text() + u'\n' + action->toolTip()
                : QStringLiteral("%1 (%2)").arg(action->text(), action->shortcut().toString(QKeySequence::NativeText)));
        setStatusTip(action->statusTip());
        setAccessibleName(action->text());
        setAccessibleDescription(action->toolTip());
    });
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
    connect(this, &QAbstractButton::clicked, action, [this, action] {
        action->trigger();
        setChecked(action->isChecked());
    });
    connect(action, &QAction::toggled, this, &QAbstractButton::setChecked);
    connect(action, &QAction::enabledChanged, this, &QAbstractButton::setEnabled);
}

void BurTile::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& p = palette();
    const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
    painter.setPen(isChecked() ? QPen(p.color(QPalette::Link), 2) : QPen(p.color(QPalette::Mid), 1));
    painter.setBrush(isChecked() || underMouse() ? p.brush(QPalette::Midlight) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(frame, kRadius, kRadius);
    if (hasFocus()) {
        // The ring of every other button, within the frame of the one that is chosen.
        painter.setPen(QPen(p.color(QPalette::Link), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(isChecked() ? frame.adjusted(3, 3, -3, -3) : frame, kRadius - 2, kRadius - 2);
    }
    painter.setOpacity(isEnabled() ? 1.0 : 0.38);

    painter.save();
    painter.translate(width() / 2.0, 50.0);
    painter.scale(kPxPerMm, kPxPerMm);
    painter.setPen(Qt::NoPen);
    painter.setBrush(p.color(QPalette::PlaceholderText));
    painter.drawRect(QRectF(-m_bur.shankRadiusMm, -kTopMm, 2 * m_bur.shankRadiusMm, kTopMm - m_bur.headLengthMm + 0.1));
    painter.setBrush(p.color(QPalette::WindowText));
    painter.drawPath(headOf(m_bur));
    painter.restore();

    painter.setFont(typeface(kSmall, isChecked() ? QFont::DemiBold : QFont::Normal));
    painter.setPen(p.color(isChecked() ? QPalette::WindowText : QPalette::PlaceholderText));
    painter.drawText(QRect(0, 51, width(), 18), Qt::AlignCenter,
                     QString::fromUtf8(m_bur.id.data(), static_cast<qsizetype>(m_bur.id.size())));
}

BurChooser::BurChooser(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent)
{
    text::inEveryLanguage(this, [this] { setAccessibleName(tr("Burs")); });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace2);
    const auto burs = core::drilling::burs();
    for (qsizetype k = 0; k < actions.size(); ++k)
        row->addWidget(new BurTile(burs[static_cast<std::size_t>(k)], actions[k], this));
}

}  // namespace ui::shell
