// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/InfractionCard.h"

#include <algorithm>

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/LineIcon.h"
#include "ui/kit/OffBur.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"

namespace ui::practice {
namespace {

using namespace ui::kit;
using core::grading::RuleViolation;

constexpr int kCardWidthPx = 460;
constexpr int kWarningIconPx = 32;

}  // namespace

QString breachName(const core::grading::Infraction& infraction)
{
    const QString value = text::number(infraction.value, 2);
    const QString limit = text::number(infraction.limit, 2);
    switch (infraction.breach) {
    case RuleViolation::PulpExposed:
        return QCoreApplication::translate("Breach", "The pulp is exposed");
    case RuleViolation::Perforated:
        return QCoreApplication::translate("Breach", "The tooth is perforated");
    case RuleViolation::TooDeep:
        return QCoreApplication::translate("Breach", "Deeper than %1 mm").arg(limit);
    case RuleViolation::RidgeCut:
        return QCoreApplication::translate("Breach", "The marginal ridge is thinner than %1 mm").arg(limit);
    case RuleViolation::WrongPlace:
        return QCoreApplication::translate("Breach", "Cut outside the target area");
    case RuleViolation::TooMuchForce:
        return QCoreApplication::translate("Breach", "Pressed with %1 N; the limit is %2 N").arg(value, limit);
    case RuleViolation::BurInAir:
        return QCoreApplication::translate("Breach", "The bur ran without contact for %1 s").arg(limit);
    case RuleViolation::NeighbourHit:
        return QCoreApplication::translate("Breach", "The running bur touched the adjacent tooth");
    case RuleViolation::WrongBur:
        break;
    }
    return QCoreApplication::translate("Breach", "Cut with a bur that this lesson does not allow");
}

QString breachReason(RuleViolation breach)
{
    switch (breach) {
    case RuleViolation::PulpExposed:
        return QCoreApplication::translate("Breach",
                                           "An exposed pulp usually dies, because cut odontoblasts do not recover. "
                                           "Watch the section and leave half a millimetre of dentin.");
    case RuleViolation::Perforated:
        return QCoreApplication::translate("Breach",
                                           "A perforated tooth is usually lost. Watch the depth in the section.");
    case RuleViolation::TooDeep:
        return QCoreApplication::translate("Breach", "Cutting deeper than necessary weakens the tooth and comes close "
                                                     "to the pulp. The section shows how deep you are.");
    case RuleViolation::RidgeCut:
        return QCoreApplication::translate("Breach",
                                           "A thin marginal ridge breaks under load. Stop the bur's outer edge "
                                           "earlier.");
    case RuleViolation::WrongPlace:
        return QCoreApplication::translate(
            "Breach", "Sound tissue does not grow back. The dashed line in the section shows what to cut.");
    case RuleViolation::TooMuchForce:
        return QCoreApplication::translate("Breach", "About 1 N cuts best; more heats the pulp, stalls the turbine and "
                                                     "slips. Let the bur do the work.");
    case RuleViolation::BurInAir:
        return QCoreApplication::translate(
            "Breach", "A running bur can injure lips and cheeks. Stop it when you are not cutting.");
    case RuleViolation::NeighbourHit:
        return QCoreApplication::translate("Breach", "A nick in the adjacent tooth collects plaque and decays. Stay "
                                                     "inside the outline; N shows the adjacent teeth.");
    case RuleViolation::WrongBur:
        break;
    }
    return QCoreApplication::translate(
        "Breach", "The shape of the bur determines the shape of the cavity. Choose a bur that the lesson lists.");
}

InfractionCard::InfractionCard(QWidget* parent) : QFrame(parent)
{
    setProperty("kind", "notice");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    row->setSpacing(kSpace4);
    auto* icon = new QLabel(this);
    icon->setPixmap(
        linePixmap(QStringLiteral("warning"), tones(roomPalette()).harmText, kWarningIconPx, devicePixelRatioF()));
    row->addWidget(icon, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace2);
    m_what = new QLabel(this);
    m_what->setFont(typeface(kTitle, QFont::DemiBold));
    m_what->setWordWrap(true);
    m_what->setObjectName(QStringLiteral("infraction"));
    m_why = new QLabel(this);
    m_why->setWordWrap(true);
    column->addWidget(m_what);
    column->addWidget(m_why);
    m_buttons = new QHBoxLayout;
    m_buttons->setSpacing(kSpace2);
    m_takeBack = new QPushButton(this);
    text::bindTranslation(m_takeBack, [this] {
        m_takeBack->setText(tr("Undo"));
        m_takeBack->setAccessibleName(m_takeBack->text());
        m_takeBack->setToolTip(tr("Restore the tooth as it was before this; you can redo it (Enter)"));
    });
    m_takeBack->setProperty("kind", "filled");
    m_takeBack->setObjectName(QStringLiteral("takeBack"));
    m_goOnButton = new QPushButton(this);
    text::bindTranslation(m_goOnButton, [this] {
        m_goOnButton->setText(tr("Continue"));
        m_goOnButton->setToolTip(tr("Keep the tooth as it is and continue (Esc)"));
        m_goOnButton->setAccessibleName(m_goOnButton->text());
    });
    m_goOnButton->setObjectName(QStringLiteral("goOn"));
    m_buttons->addWidget(m_takeBack);
    m_buttons->addWidget(m_goOnButton);
    m_buttons->addStretch(1);
    column->addLayout(m_buttons);
    row->addLayout(column, 1);
    connect(m_takeBack, &QPushButton::clicked, this, &InfractionCard::takeBack);
    connect(m_goOnButton, &QPushButton::clicked, this, &InfractionCard::goOn);
    // A press on the tooth moves the focus. While the card is open, Enter must press its button.
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        if (isVisible() && qobject_cast<const tooth::ToothView*>(now) != nullptr)
            setFocus();
    });
    text::bindTranslation(this, [this] { retranslateUi(); });
    hide();
}

void InfractionCard::retranslateUi()
{
    if (!m_told)
        return;
    m_what->setText(breachName(*m_told));
    m_why->setText(breachReason(m_told->breach));
    setAccessibleName(m_what->text());
    setAccessibleDescription(m_why->text());
}

void InfractionCard::goOn()
{
    hide();
    emit goOnRequested();
}

bool InfractionCard::takeBack()
{
    if (isHidden() || m_takeBack->isHidden())
        return false;
    hide();
    emit takeBackRequested();
    return true;
}

void InfractionCard::tell(const core::grading::Infraction& infraction, bool canTakeBack)
{
    m_told = infraction;
    retranslateUi();
    m_takeBack->setVisible(canTakeBack);
    show();
    raise();
    setFocusProxy(canTakeBack ? m_takeBack : m_goOnButton);
}

void InfractionCard::placeIn(const QRect& area, const std::optional<QPointF>& bur)
{
    const int width = std::min(kCardWidthPx, area.width() - 2 * kSpace2);
    // Buttons that do not fit side by side are one below the other.
    const int beside = m_takeBack->sizeHint().width() + m_goOnButton->sizeHint().width() + kWarningIconPx + 4 * kSpace4;
    m_buttons->setDirection(beside <= width ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    layout()->activate();  // changed text may need another line
    resize(width, layout()->totalHeightForWidth(width));
    const QRect atFoot(QPoint(area.center().x() - width / 2, area.bottom() - kSpace6 - height()), size());
    move(kit::placeOffBur(bur, atFoot, QRect({atFoot.left(), area.top() + kBelowMessagePx}, size()))
             .topLeft()
             .toPoint());
}

void InfractionCard::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        (m_goOnButton->hasFocus() || m_takeBack->isHidden() ? m_goOnButton : m_takeBack)->click();
    else
        QFrame::keyPressEvent(event);
}

}  // namespace ui::practice
