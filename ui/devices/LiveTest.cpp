// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/LiveTest.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "core/session/RestHeight.h"
#include "ui/devices/ButtonLights.h"
#include "ui/devices/ForceTest.h"
#include "ui/devices/IntervalChart.h"
#include "ui/devices/PositionView.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr double kUsPerMs = 1000.0;

QLabel* captionLabel(QWidget* parent)
{
    return kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, parent);
}

}  // namespace

LiveTest::LiveTest(QWidget* parent)
    : QFrame(parent), m_columns(new QBoxLayout(QBoxLayout::LeftToRight, this)), m_position(new PositionView(this)),
      m_force(new ForceTest(this)), m_buttons(new ButtonLights(this)), m_intervals(new IntervalChart(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("liveTest"));
    m_columns->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    m_columns->setSpacing(kSpace6);
    auto* hand = new QVBoxLayout;
    hand->setSpacing(kSpace1);
    auto* where = captionLabel(this);
    hand->addWidget(where);
    hand->addWidget(m_position);
    hand->addSpacing(kSpace2);
    auto* pressed = captionLabel(this);
    hand->addWidget(pressed);
    hand->addWidget(m_buttons);
    hand->addStretch(1);
    m_columns->addLayout(hand, 1);

    auto* link = new QVBoxLayout;
    link->setSpacing(kSpace1);
    auto* push = captionLabel(this);
    link->addWidget(push);
    link->addWidget(m_force, 0, Qt::AlignLeft);
    link->addSpacing(kSpace2);
    auto* jitter = captionLabel(this);
    link->addWidget(jitter);
    link->addWidget(m_intervals);
    auto* figures = new QGridLayout;
    figures->setHorizontalSpacing(kSpace4);
    figures->setVerticalSpacing(0);
    QLabel* rate = nullptr;
    QLabel* trip = nullptr;
    QLabel* slowTrip = nullptr;
    QLabel* lost = nullptr;
    QLabel* rejected = nullptr;
    m_rate = addFigure(*figures, 0, 0, "rate", rate);
    m_trip = addFigure(*figures, 0, 1, "roundTrip", trip);
    m_slowTrip = addFigure(*figures, 0, 2, "slowTrip", slowTrip);
    m_lost = addFigure(*figures, 1, 0, "lost", lost);
    m_rejected = addFigure(*figures, 1, 1, "rejected", rejected);
    link->addLayout(figures);
    link->addStretch(1);
    m_columns->addLayout(link, 1);
    text::bindTranslation(this, [=] {
        where->setText(tr("Position"));
        pressed->setText(tr("Grip buttons"));
        push->setText(tr("Force: hold a button, and the device pushes your hand gently"));
        jitter->setText(tr("Intervals between answers"));
        rate->setText(tr("Answers"));
        trip->setText(tr("Round trip"));
        //: Of the time from a request to its answer: 99 of 100 are shorter
        slowTrip->setText(tr("99 % below"));
        //: Requests without an answer
        lost->setText(tr("Lost"));
        //: Answers that were not plausible
        rejected->setText(tr("Rejected"));
    });
}

void LiveTest::setNarrow(bool isNarrow)
{
    m_columns->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

kit::TabularDigitsLabel* LiveTest::addFigure(QGridLayout& grid, int row, int column, const char* name, QLabel*& caption)
{
    caption = captionLabel(this);
    auto* value = new TabularDigitsLabel(this);
    value->setFont(typeface(kTitle, QFont::Medium));
    value->setObjectName(QLatin1String(name));
    grid.addWidget(caption, 2 * row, column);
    grid.addWidget(value, 2 * row + 1, column);
    grid.setColumnStretch(column, 1);
    return value;
}

void LiveTest::setReport(const core::session::DeviceReport& report, double scale)
{
    m_position->setTip(report.tipMm, core::session::kHandReachMm / scale);
    m_buttons->setHeld(report.buttons);
    const core::session::ExchangeFigures& exchange = report.exchange;
    m_intervals->setFigures(exchange);
    m_rate->setText(text::number(exchange.rateHz, 0), QStringLiteral("Hz"));
    m_trip->setText(text::number(exchange.roundTripUs / kUsPerMs, 2), QStringLiteral("ms"));
    m_slowTrip->setText(text::number(exchange.slowTripUs / kUsPerMs, 2), QStringLiteral("ms"));
    m_lost->setText(QLocale().toString(static_cast<qulonglong>(exchange.lost)));
    m_rejected->setText(QLocale().toString(static_cast<qulonglong>(exchange.rejected)));
}

}  // namespace ui::devices
