// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/PenCard.h"

#include <cmath>

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/devices/PenField.h"
#include "ui/devices/ResponseCurve.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::devices {
namespace {

using namespace ui::kit;
using core::settings::PenSettings;

constexpr double kPenCurveStep = 0.1;
constexpr double kPressurePercent = 100.0;
constexpr int kForceDecimals = 2;

}  // namespace

PenCard::PenCard(QWidget* parent)
    : QFrame(parent), m_field(new PenField(this)),
      m_words(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)),
      m_curve(kit::numberInput(PenSettings::kLeastCurve, PenSettings::kMostCurve, 1, {}, {}, this)),
      m_picture(new ResponseCurve(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("pen"));
    m_words->setObjectName(QStringLiteral("penWords"));
    m_curve->setObjectName(QStringLiteral("penCurve"));
    m_curve->setSingleStep(kPenCurveStep);
    auto* title = kit::formWords({}, kTitle, QFont::Medium, QPalette::WindowText, this);
    auto* tilt = kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, this);
    auto* caption = kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, this);
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace2);
    column->addWidget(title);
    column->addWidget(m_field);
    column->addWidget(m_words);
    column->addWidget(tilt);
    column->addStretch(1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    row->setSpacing(kSpace6);
    row->addLayout(column, 1);
    row->addLayout(makeCurve(caption));

    connect(m_field, &PenField::penMoved, this, [this](double pressure) {
        m_seen = Seen::Pen;
        m_pressure = pressure;
        showWords();
    });
    connect(m_field, &PenField::mousePressed, this, [this] {
        m_seen = Seen::Mouse;
        m_pressure = 0.0;
        showWords();
    });
    connect(m_curve, &QDoubleSpinBox::valueChanged, this, [this](double curve) {
        m_settings.curve = curve;
        showCurve();
        showWords();
        emit settingsChanged(m_settings);
    });
    text::bindTranslation(this, [this, title, tilt, caption] {
        title->setText(tr("Pen"));
        tilt->setText(tr("The tilt of the pen is ignored: the bur stays upright."));
        //: Of a pen: 1 is a straight line
        caption->setText(tr("Curve"));
        m_curve->setAccessibleName(caption->text());
        m_curve->setToolTip(tr("1 is a straight line. With more, a light touch presses more weakly."));
        m_picture->setName(tr("Force over the pressure of the pen"));
        showWords();
    });
    setSettings({});
}

QLayout* PenCard::makeCurve(QLabel* caption)
{
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace1);
    column->addWidget(m_picture);
    column->addWidget(caption);
    column->addWidget(m_curve, 0, Qt::AlignLeft);
    column->addStretch(1);
    return column;
}

void PenCard::setSettings(const PenSettings& settings)
{
    m_settings = settings;
    const QSignalBlocker silent(m_curve);
    kit::showNumber(*m_curve, settings.curve);
    showCurve();
    showWords();
}

void PenCard::setFullForce(double newtons)
{
    m_fullForceN = newtons;
    showWords();
}

void PenCard::showCurve()
{
    m_picture->setCurve([settings = m_settings](double pressure) { return settings.shareAt(pressure); });
}

void PenCard::showWords()
{
    const bool isDown = m_pressure > 0.0;
    m_picture->setInput(isDown ? std::optional(m_pressure) : std::nullopt);
    const QString fullForce = text::number(m_fullForceN, kForceDecimals);
    if (m_seen == Seen::Nothing)
        m_words->setText(tr("No pen has been seen yet. Press it in the field, or move it over the field."));
    else if (m_seen == Seen::Mouse)
        //: %1: newtons
        m_words->setText(tr("That was a mouse, or a pen whose driver reports no pressure. The bur presses with %1 N.")
                             .arg(fullForce));
    else if (!isDown)
        m_words->setText(tr("The pen hovers: the bur follows it and does not press."));
    else
        //: %1: per cent; %2 and %3: newtons
        m_words->setText(tr("Pressure %1 %: the bur presses with %2 N of %3 N.")
                             .arg(text::number(kPressurePercent * m_pressure, 0),
                                  text::number(m_fullForceN * m_settings.shareAt(m_pressure), kForceDecimals),
                                  fullForce));
}

}  // namespace ui::devices
