// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/TrackingFigures.h"

#include <cstddef>

#include <QGridLayout>
#include <QLabel>

#include "ui/kit/FormInputs.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

enum Figure : std::size_t { Rate, Seen, Find, Latency, Jitter };
constexpr std::array<const char*, 5> kFigureNames{"trackingRate", "trackingSeen", "trackingFind", "trackingLatency",
                                                  "trackingJitter"};
constexpr int kFigureColumns = 2;
constexpr double kHundred = 100.0;
const QString kNoFigure = QStringLiteral("–");

}  // namespace

TrackingFigures::TrackingFigures(QWidget* parent) : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kSpace4);
    grid->setVerticalSpacing(0);
    std::array<QLabel*, kFigureNames.size()> captions{};
    for (std::size_t k = 0; k < kFigureNames.size(); ++k) {
        const int row = 3 * (static_cast<int>(k) / kFigureColumns);
        const int column = static_cast<int>(k) % kFigureColumns;
        captions.at(k) = kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, this);
        m_values.at(k) = new TabularDigitsLabel(this);
        m_values.at(k)->setFont(typeface(kFigure, QFont::Medium));
        m_values.at(k)->setObjectName(QLatin1String(kFigureNames.at(k)));
        grid->addWidget(captions.at(k), row, column, Qt::AlignBottom);
        grid->addWidget(m_values.at(k), row + 1, column);
        grid->setColumnStretch(column, 1);
        grid->setRowMinimumHeight(row + 2, kSpace2);
    }
    clear();
    text::bindTranslation(this, [this, captions] {
        captions.at(Rate)->setText(tr("Pictures per second"));
        //: Share of the pictures in which the tag was found
        captions.at(Seen)->setText(tr("Pictures with the tag"));
        captions.at(Find)->setText(tr("Time to find it"));
        //: Time from a picture of the camera to the turn of the view
        captions.at(Latency)->setText(tr("Latency"));
        //: How far the measured place of a head at rest moves
        captions.at(Jitter)->setText(tr("Jitter"));
        for (std::size_t k = 0; k < captions.size(); ++k)
            m_values.at(k)->setAccessibleName(captions.at(k)->text());
    });
}

void TrackingFigures::setReport(const core::tracking::TrackerReport& report)
{
    const QString ms = QStringLiteral("ms");
    m_values.at(Rate)->setText(text::number(report.hz, 0));
    m_values.at(Seen)->setText(text::number(kHundred * report.seenShare, 0), QStringLiteral("%"));
    m_values.at(Find)->setText(text::number(report.findMs + report.poseMs, 1), ms);
    if (report.latencyMs > 0.0)
        m_values.at(Latency)->setText(text::number(report.latencyMs, 0), ms);
    else
        m_values.at(Latency)->setText(kNoFigure);
    if (report.jitterMm > 0.0)
        m_values.at(Jitter)->setText(text::number(report.jitterMm, 2), QStringLiteral("mm"));
    else
        m_values.at(Jitter)->setText(kNoFigure);
}

void TrackingFigures::clear()
{
    for (TabularDigitsLabel* value : m_values)
        value->setText(kNoFigure);
}

}  // namespace ui::devices
