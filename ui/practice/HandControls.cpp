// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/HandControls.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/kit/AppSettings.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"

namespace ui::practice {
namespace {

constexpr const char* kFeedKey = "hand/feed";

using tooth::PointerControl;

int stepsOf(double value, double step)
{
    return static_cast<int>(std::lround(value / step));
}

}  // namespace

HandControls::HandControls(tooth::ToothView& view, QWidget* parent)
    : QWidget(parent), m_view(view), m_sliders(new QWidget(this)), m_device(new QLabel(this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_sliders);
    column->addWidget(m_device);
    m_device->setObjectName(QStringLiteral("forceDevice"));
    m_device->setFont(kit::typeface(kit::kSmall));
    m_device->setForegroundRole(QPalette::PlaceholderText);
    m_device->setWordWrap(true);
    m_device->hide();
    auto* grid = new QGridLayout(m_sliders);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kit::kSpace2);
    grid->setVerticalSpacing(kit::kSpace1);
    grid->setColumnStretch(1, 1);
    const auto addRow = [&](int row, QWidget* caption, const char* name, double low, double high, double step) {
        caption->setFont(kit::typeface(kit::kSmall));
        caption->setForegroundRole(QPalette::PlaceholderText);
        auto* slider = new QSlider(Qt::Horizontal, m_sliders);
        slider->setRange(stepsOf(low, step), stepsOf(high, step));
        slider->setPageStep(5);
        slider->setFocusPolicy(Qt::TabFocus);
        slider->setObjectName(QLatin1String(name));
        auto* text = new kit::TabularDigitsLabel(m_sliders);
        text->setFont(kit::typeface(kit::kBody, QFont::Medium));
        text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(caption, row, 0);
        grid->addWidget(slider, row, 1);
        grid->addWidget(text, row, 2);
        return std::pair(slider, text);
    };
    auto* feed = new QLabel(m_sliders);
    m_stopOn = new QCheckBox(m_sliders);
    m_stopOn->setObjectName(QStringLiteral("depthStopOn"));
    auto* push = new QLabel(m_sliders);
    std::tie(m_feed, m_feedText) = addRow(0, feed, "feed", PointerControl::kSlowestMmPerS,
                                          PointerControl::kFastestMmPerS, PointerControl::kStepMmPerS);
    std::tie(m_stop, m_stopText) = addRow(1, m_stopOn, "depthStop", PointerControl::kShallowestMm,
                                          PointerControl::kDeepestMm, PointerControl::kStepMm);
    std::tie(m_push, m_pushText) =
        addRow(2, push, "pushForce", PointerControl::kWeakestN, PointerControl::kStrongestN, PointerControl::kStepN);
    feed->setBuddy(m_feed);
    push->setBuddy(m_push);
    bool isNumber = false;
    const double kept = kit::memory().value(QLatin1String(kFeedKey)).toDouble(&isNumber);
    if (isNumber && kept >= PointerControl::kSlowestMmPerS && kept <= PointerControl::kFastestMmPerS)
        m_view.setFeed(kept);
    text::bindTranslation(this, [this, feed, push] {
        feed->setText(tr("Feed"));
        m_feed->setAccessibleName(tr("Feed, millimetres per second"));
        m_feed->setToolTip(tr("How fast the bur goes down at most while you press"));
        m_stopOn->setText(tr("Depth stop"));
        m_stopOn->setToolTip(tr("The bur stops at this depth below the original surface"));
        m_stop->setAccessibleName(tr("Depth stop, millimetres"));
        m_stop->setToolTip(tr("To change the depth, turn the mouse wheel while you press the button or hold Shift"));
        push->setText(tr("Push with"));
        m_push->setAccessibleName(tr("Push with, newtons"));
        m_push->setToolTip(tr("How hard the mouse and the keys push the bur against the tooth at most"));
        for (QSlider* slider : {m_feed, m_stop, m_push})
            slider->setStatusTip(slider->toolTip());
        showHand();
        setForceDevice(m_deviceName);
    });
    connect(m_feed, &QSlider::valueChanged, this, [this](int steps) { setFeed(steps * PointerControl::kStepMmPerS); });
    connect(m_stop, &QSlider::valueChanged, this,
            [this](int steps) { m_view.setDepthStop(m_stopOn->isChecked(), steps * PointerControl::kStepMm); });
    connect(m_stopOn, &QCheckBox::toggled, this,
            [this](bool on) { m_view.setDepthStop(on, m_view.hand().stopDepthMm()); });
    connect(m_push, &QSlider::valueChanged, this,
            [this](int steps) { m_view.setPushForce(steps * PointerControl::kStepN); });
    connect(&m_view, &tooth::ToothView::handChanged, this, &HandControls::showHand);
}

void HandControls::begin(bool stopIsAllowed, double depthMm)
{
    m_stopOn->setEnabled(stopIsAllowed);
    m_view.setDepthStop(stopIsAllowed, depthMm);
    m_depthMm = depthMm;
}

bool HandControls::isDeep(const core::servo::ServoState& servo) const
{
    constexpr double kNearlyMm = 0.1;
    const double belowSurfaceMm = servo.hasDepth ? servo.depthMm : 0.0;
    const double shownMm = m_view.hand().depthMm(servo.anchorMm.z).value_or(0.0);
    return servo.touching && std::max(belowSurfaceMm, shownMm) >= m_depthMm - kNearlyMm;
}

void HandControls::setFeed(double mmPerS)
{
    m_view.setFeed(mmPerS);
    kit::memory().setValue(QLatin1String(kFeedKey), m_view.hand().feedMmPerS());
}

void HandControls::reset()
{
    setFeed(PointerControl::kFirstMmPerS);
    m_view.setPushForce(PointerControl::kFirstN);
}

double HandControls::pushForce() const
{
    return m_view.hand().forceN();
}

void HandControls::setForceDevice(const QString& name)
{
    m_deviceName = name;
    m_sliders->setVisible(name.isEmpty());
    m_device->setVisible(!name.isEmpty());
    //: %1: a force device
    m_device->setText(tr("The %1 moves the bur. Feed, depth stop and force are for the mouse.").arg(name));
}

void HandControls::showHand()
{
    const PointerControl& hand = m_view.hand();
    const QSignalBlocker silent[]{QSignalBlocker(m_feed), QSignalBlocker(m_stop), QSignalBlocker(m_stopOn),
                                  QSignalBlocker(m_push)};
    m_feed->setValue(stepsOf(hand.feedMmPerS(), PointerControl::kStepMmPerS));
    m_feedText->setText(text::number(hand.feedMmPerS(), 1), tr("mm/s"));
    m_stopOn->setChecked(hand.isStopOn());
    m_stop->setEnabled(hand.isStopOn());
    m_stop->setValue(stepsOf(hand.stopDepthMm(), PointerControl::kStepMm));
    m_stopText->setText(text::number(hand.stopDepthMm(), 1), QStringLiteral("mm"));
    m_push->setValue(stepsOf(hand.forceN(), PointerControl::kStepN));
    m_pushText->setText(text::number(hand.forceN(), 1), QStringLiteral("N"));
}

}  // namespace ui::practice
