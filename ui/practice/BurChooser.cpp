// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/BurChooser.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QTransform>

#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"
#include "ui/practice/BurPicker.h"
#include "ui/render/GritColour.h"
#include "ui/text/EveryLanguage.h"

namespace ui::practice {
namespace {

constexpr double kPxPerMm = 11.0;
constexpr int kTilePx = 46;
constexpr int kPanelTilePx = 70;
constexpr int kNumberPx = 18;
constexpr int kBelowTipPx = 2;  ///< gap between the tip and the number, and above the shank
/// Length of the neck that is drawn above a head at least, mm.
constexpr double kNeckSeenMm = 0.4;
/// Lengths of a diamond bur's shank above the neck, and of its grit ring.
constexpr double kShankPx = 13.0;
constexpr double kRingPx = 5.0;
constexpr double kBladePx = 4.0;     ///< distance between blades
constexpr double kBladeSlope = 0.6;  ///< slope of a groove: horizontal pixels per vertical pixel
constexpr double kGrainPx = 2.0;

/// Returns the outline of the head, both halves, with the tip at the origin. Negative y is upwards.
QPainterPath headOf(const core::bur::Bur& bur)
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

/// Draws the grooves between blades within a head, and notches across them if it is crosscut.
void drawBlades(QPainter& painter, const QRectF& head, const QColor& groove, bool isNotched)
{
    painter.setPen(QPen(groove, 1.2));
    const double lean = kBladeSlope * head.height();
    for (double x = head.left() - lean; x < head.right(); x += kBladePx)
        painter.drawLine(QPointF(x, head.bottom()), QPointF(x + lean, head.top()));
    for (double y = head.bottom() - kBladePx; isNotched && y > head.top(); y -= kBladePx)
        painter.drawLine(QPointF(head.left(), y), QPointF(head.right(), y));
}

/// Draws grains in rows; every other row is shifted by half a grain.
void drawGrains(QPainter& painter, const QRectF& head, const QColor& grain)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(grain);
    bool isOdd = false;
    for (double y = head.bottom() - 0.5 * kGrainPx; y > head.top(); y -= 1.5 * kGrainPx, isOdd = !isOdd)
        for (double x = head.left() + (isOdd ? 0.25 : 1.5) * kGrainPx; x < head.right(); x += 2.5 * kGrainPx)
            painter.drawEllipse(QPointF(x, y), 0.5 * kGrainPx, 0.5 * kGrainPx);
}

}  // namespace

BurTile::BurTile(const core::bur::Bur& bur, QAction* action, int heightPx, QWidget* parent)
    : QAbstractButton(parent), m_bur(bur), m_heightPx(heightPx)
{
    setCheckable(true);
    setChecked(action->isChecked());
    setEnabled(action->isEnabled());
    kit::followWords(action, this, [this, action] {
        setText(action->text());
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        setToolTip(kit::Actions::isRefused(action) ? action->text() + u'\n' + action->toolTip()
                   : key.isEmpty()                 ? action->text()
                                                   : QStringLiteral("%1 (%2)").arg(action->text(), key));
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

QSize BurTile::sizeHint() const
{
    return {kTilePx, m_heightPx};
}

void BurTile::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& p = palette();
    const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
    painter.setPen(isChecked() ? QPen(p.color(QPalette::Link), 2) : QPen(p.color(QPalette::Mid), 1));
    painter.setBrush(isChecked() || underMouse() ? p.brush(QPalette::Midlight) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(frame, kit::kRadius, kit::kRadius);
    if (hasFocus()) {
        // The focus ring of all buttons; inside the frame of a checked one.
        painter.setPen(QPen(p.color(QPalette::Link), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(isChecked() ? frame.adjusted(3, 3, -3, -3) : frame, kit::kRadius - 2, kit::kRadius - 2);
    }
    painter.setOpacity(isEnabled() ? 1.0 : 0.38);

    painter.save();
    const int tip = height() - kNumberPx - kBelowTipPx;
    const double shankPx = m_bur.isDiamond() ? kRingPx + 1.0 : 0.0;
    const double room = tip - kBelowTipPx - shankPx;
    const double scale = std::min(kPxPerMm, room / (m_bur.headLengthMm + kNeckSeenMm));
    const double neckPx = 2.0 * m_bur.shankRadiusMm * scale;
    const QPainterPath head = QTransform::fromScale(scale, scale).map(headOf(m_bur));
    painter.translate(width() / 2.0, tip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(p.color(QPalette::PlaceholderText));
    painter.drawRect(QRectF(-0.5 * neckPx, -room, neckPx, room - (m_bur.headLengthMm - 0.1) * scale));
    if (m_bur.isDiamond()) {
        const QRectF ring(-0.5 * kShankPx, -room - kRingPx, kShankPx, kRingPx);
        painter.setPen(QPen(p.color(QPalette::PlaceholderText), 1.0));
        painter.setBrush(render::gritColour(m_bur.grit).value_or(p.color(QPalette::PlaceholderText)));
        painter.drawRect(ring);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(p.color(m_bur.isDiamond() ? QPalette::PlaceholderText : QPalette::WindowText));
    painter.drawPath(head);
    painter.setClipPath(head);
    if (m_bur.isDiamond())
        drawGrains(painter, head.boundingRect(), p.color(QPalette::WindowText));
    else
        drawBlades(painter, head.boundingRect(), p.color(QPalette::Mid), m_bur.isCrosscut());
    painter.restore();

    painter.setFont(kit::typeface(kit::kSmall, isChecked() ? QFont::DemiBold : QFont::Normal));
    painter.setPen(p.color(isChecked() ? QPalette::WindowText : QPalette::PlaceholderText));
    painter.drawText(QRect(0, height() - kNumberPx - 1, width(), kNumberPx), Qt::AlignCenter,
                     QString::fromStdString(m_bur.id));
}

BurChooser::BurChooser(kit::Actions& actions, QWidget* parent)
    : QWidget(parent), m_actions(actions), m_row(new QHBoxLayout(this)), m_picker(new BurPicker(actions, this)),
      m_all(kit::barButton(actions.allBurs, false, this))
{
    text::bindTranslation(this, [this] { setAccessibleName(tr("Burs")); });
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(kit::kSpace1);
    connect(actions.allBurs, &QAction::triggered, this, [this] { m_picker->open(*this); });
    connect(&actions, &kit::Actions::bursAtHandChanged, this, &BurChooser::arrange);
    for (int k = 0; k < actions.burs.size(); ++k)
        m_tiles << new BurTile(core::bur::burs()[static_cast<std::size_t>(k)], actions.burs[k], kPanelTilePx, this);
    for (QAction* bur : std::as_const(actions.burs))
        connect(bur, &QAction::toggled, this, [this](bool on) {
            if (on)
                arrange();
        });
    arrange();
}

/// Shows the tiles of the favourite burs, and of the bur in use if it is not among them.
void BurChooser::arrange()
{
    QList<int> wanted = m_actions.bursAtHand();
    for (int k = 0; k < m_tiles.size(); ++k)
        if (m_actions.burs[k]->isChecked() && !wanted.contains(k))
            wanted << k;
    while (m_row->count() > 0)
        delete m_row->takeAt(0);
    for (int k = 0; k < m_tiles.size(); ++k)
        m_tiles[k]->setVisible(wanted.contains(k));
    QWidget* before = nullptr;
    for (const int bur : std::as_const(wanted)) {
        m_row->addWidget(m_tiles[bur]);
        if (before != nullptr)
            setTabOrder(before, m_tiles[bur]);
        before = m_tiles[bur];
    }
    m_row->addWidget(m_all);
}

}  // namespace ui::practice
