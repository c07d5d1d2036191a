// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/PedalSetupCard.h"

#include <cmath>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/devices/ControllerWords.h"
#include "ui/devices/ResponseCurve.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;
using core::settings::PedalSettings;

constexpr double kWholePercent = 100.0;
constexpr double kCurveStep = 0.1;
constexpr double kMsPerSecond = 1000.0;

}  // namespace

PedalSetupCard::PedalSetupCard(QWidget* parent)
    : QFrame(parent), m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)),
      m_teach(new QPushButton(this)), m_inverted(new QCheckBox(this)),
      m_deadZone(kit::countInput(0, static_cast<int>(kWholePercent * PedalSettings::kMostDeadZone), this)),
      m_curve(kit::numberInput(PedalSettings::kLeastCurve, PedalSettings::kMostCurve, 1, {}, {}, this)),
      m_picture(new ResponseCurve(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("pedalSetup"));
    m_words->setObjectName(QStringLiteral("pedalWords"));
    m_teach->setObjectName(QStringLiteral("teachPedal"));
    m_teach->setCheckable(true);
    m_inverted->setObjectName(QStringLiteral("pedalInverted"));
    m_deadZone->setObjectName(QStringLiteral("pedalDeadZone"));
    m_deadZone->setSuffix(QStringLiteral(" %"));
    m_deadZone->setFixedWidth(kit::kInputPx);
    m_curve->setObjectName(QStringLiteral("pedalCurve"));
    m_curve->setSingleStep(kCurveStep);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    row->setSpacing(kSpace6);
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace2);
    column->addWidget(m_words);
    column->addWidget(m_teach, 0, Qt::AlignLeft);
    auto* inputs = new QGridLayout;
    inputs->setHorizontalSpacing(kSpace4);
    inputs->setVerticalSpacing(kSpace1);
    auto* deadCaption = kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, this);
    auto* curveCaption = kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, this);
    inputs->addWidget(deadCaption, 0, 0);
    inputs->addWidget(curveCaption, 0, 1);
    inputs->addWidget(m_deadZone, 1, 0, Qt::AlignLeft);
    inputs->addWidget(m_curve, 1, 1, Qt::AlignLeft);
    column->addLayout(inputs);
    column->addWidget(m_inverted);
    row->addLayout(column, 1);
    row->addWidget(m_picture, 0, Qt::AlignTop);

    connect(m_teach, &QPushButton::toggled, this, &PedalSetupCard::setLearning);
    connect(m_inverted, &QCheckBox::toggled, this, [this](bool isInverted) {
        m_settings.shape.isInverted = isInverted;
        showCurve();
        emit settingsChanged(m_settings);
    });
    connect(m_deadZone, &QSpinBox::valueChanged, this, [this](int percent) {
        m_settings.shape.deadZone = percent / kWholePercent;
        showCurve();
        emit settingsChanged(m_settings);
    });
    connect(m_curve, &QDoubleSpinBox::valueChanged, this, [this](double curve) {
        m_settings.shape.curve = curve;
        showCurve();
        emit settingsChanged(m_settings);
    });
    text::bindTranslation(this, [this, deadCaption, curveCaption] {
        //: Of a pedal: the bur runs while it is released
        m_inverted->setText(tr("Inverted"));
        m_inverted->setAccessibleName(m_inverted->text());
        //: Of a pedal: the part of its travel in which the bur stands
        deadCaption->setText(tr("Dead zone"));
        m_deadZone->setAccessibleName(deadCaption->text());
        //: Of a pedal: 1 is a straight line
        curveCaption->setText(tr("Curve"));
        m_curve->setAccessibleName(curveCaption->text());
        m_curve->setToolTip(tr("1 is a straight line. With more, slow speeds have more of the travel."));
        m_picture->setName(tr("Speed of the bur over the travel of the pedal"));
        showWords();
    });
}

void PedalSetupCard::setSettings(const ControllerSettings& settings)
{
    m_settings = settings;
    const QSignalBlocker silentInverted(m_inverted);
    m_inverted->setChecked(settings.shape.isInverted);
    const QSignalBlocker silentDeadZone(m_deadZone);
    m_deadZone->setValue(static_cast<int>(std::lround(kWholePercent * settings.shape.deadZone)));
    const QSignalBlocker silentCurve(m_curve);
    kit::showNumber(*m_curve, settings.shape.curve);
    showCurve();
    for (QWidget* input : {static_cast<QWidget*>(m_inverted), static_cast<QWidget*>(m_deadZone),
                           static_cast<QWidget*>(m_curve), static_cast<QWidget*>(m_picture)})
        input->setEnabled(settings.axis != kNoAxis);
    showWords();
}

void PedalSetupCard::setController(const core::session::Controller& controller)
{
    const bool isOther = controller.instance != m_controller.instance;
    m_controller = controller;
    if (isOther) {
        stopLearning();
        showWords();
    }
    const auto axis = static_cast<std::size_t>(m_settings.axis);
    const bool hasAxis = m_settings.axis != kNoAxis && axis < controller.axes.size();
    m_picture->setInput(hasAxis ? std::optional(m_settings.shape.travelAt(static_cast<double>(controller.axes[axis])))
                                : std::nullopt);
    if (!m_learner)
        return;
    const double seconds = static_cast<double>(m_sinceReading.restart()) / kMsPerSecond;
    const auto learnt = m_learner->update(controller.axes, seconds);
    if (!learnt)
        return;
    stopLearning();
    m_settings.axis = learnt->axis;
    m_settings.shape.restReading = learnt->restReading;
    m_settings.shape.fullReading = learnt->fullReading;
    m_settings.shape.isInverted = false;
    setSettings(m_settings);
    emit settingsChanged(m_settings);
    emit taught();
}

void PedalSetupCard::stopLearning()
{
    m_teach->setChecked(false);
}

void PedalSetupCard::setLearning(bool isLearning)
{
    m_learner.reset();
    if (isLearning)
        m_learner.emplace();
    m_sinceReading.start();
    showWords();
}

void PedalSetupCard::showCurve()
{
    m_picture->setCurve([shape = m_settings.shape](double travel) { return shape.speedAt(travel); });
}

void PedalSetupCard::showWords()
{
    if (isLearning())
        m_words->setText(tr("Press the pedal fully and release it."));
    else if (m_settings.axis == kNoAxis)
        m_words->setText(tr("No pedal has been taught. The speed of the bur follows its travel once it has."));
    else
        //: %1: "Left trigger" or "Axis 1"
        m_words->setText(tr("The speed of the bur follows: %1.")
                             .arg(axisName(m_controller, static_cast<std::size_t>(m_settings.axis))));
    m_teach->setText(isLearning() ? tr("Cancel") : tr("Teach the pedal"));
    m_teach->setAccessibleName(m_teach->text());
}

}  // namespace ui::devices
