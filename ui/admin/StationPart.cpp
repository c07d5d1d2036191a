// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/StationPart.h"

#include <cmath>
#include <utility>

#include <QGridLayout>
#include <QInputDevice>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::admin {

using namespace ui::kit;

namespace {

constexpr int kRows = 8;
constexpr int kKeyShown = 16;
constexpr int kLongestIdle = 240;

/// Returns the names of the pointing devices that Qt reports.
QString foundDevices()
{
    QStringList found;
    for (const QInputDevice* device : QInputDevice::devices()) {
        const bool isPen =
            device->type() == QInputDevice::DeviceType::Stylus || device->type() == QInputDevice::DeviceType::Airbrush;
        const bool isPointer = isPen || device->type() == QInputDevice::DeviceType::Mouse ||
                               device->type() == QInputDevice::DeviceType::TouchPad ||
                               device->type() == QInputDevice::DeviceType::TouchScreen;
        QString name = device->name();
        name.removeIf([](QChar letter) { return !letter.isPrint(); });  // X11 appends unprintable characters
        if (isPointer && !name.isEmpty())
            found << (isPen ? StationPart::tr("%1 (pen)").arg(name) : name);
    }
    found.removeDuplicates();
    return found.isEmpty() ? StationPart::tr("a mouse") : found.join(QStringLiteral(", "));
}

}  // namespace

StationPart::StationPart(QWidget* parent)
    : QWidget(parent), m_grid(new QGridLayout), m_idle(kit::countInput(1, kLongestIdle, this)),
      m_idleWords(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    m_grid->setHorizontalSpacing(kSpace6);
    m_grid->setVerticalSpacing(kSpace2);
    m_grid->setColumnStretch(1, 1);
    for (int row = 0; row < kRows; ++row) {
        m_names << kit::formWords({}, kBody, QFont::Normal, QPalette::PlaceholderText, this);
        m_values << kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this);
        m_names.back()->setWordWrap(false);
        m_values.back()->setTextFormat(Qt::PlainText);
        m_values.back()->setTextInteractionFlags(Qt::TextSelectableByMouse);
        m_grid->addWidget(m_names.back(), row, 0, Qt::AlignTop);
        m_grid->addWidget(m_values.back(), row, 1);
    }
    column->addLayout(m_grid);
    column->addWidget(line(this));
    auto* idle = new QHBoxLayout;
    m_idle->setObjectName(QStringLiteral("idleMinutes"));
    idle->addWidget(m_idleWords);
    idle->addWidget(m_idle);
    idle->addStretch(1);
    column->addLayout(idle);
    column->addStretch(1);
    m_idleWords->setWordWrap(false);
    m_idleWords->setBuddy(m_idle);
    connect(m_idle, &QSpinBox::editingFinished, this, [this] {
        if (std::exchange(m_idleMinutes, m_idle->value()) != m_idle->value())
            emit idleMinutesRequested(m_idle->value());
    });
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void StationPart::retranslateUi()
{
    m_idleWords->setText(tr("Everywhere in the school, a place that was left is locked after"));
    m_idle->setSuffix(u' ' + tr("min"));
    m_idle->setAccessibleName(tr("Minutes after which a place that was left is locked"));
    const QString servo = text::number(m_facts.servoHz, 0);
    const QString measured = std::isfinite(m_facts.middleMs) && std::isfinite(m_facts.mostMs)
                                 //: Times between two servo ticks
                                 ? tr("%1 ms in the middle, 99 of 100 within %2 ms")
                                       .arg(text::number(m_facts.middleMs, 2), text::number(m_facts.mostMs, 2))
                                 : tr("not yet");
    const QStringList names{tr("Drilled with"),        tr("Found here"), tr("Servo loop"),   tr("Measured"),
                            tr("Key of this station"), tr("Database"),   tr("On their way"), tr("Program")};
    const QStringList values{m_facts.hand,
                             foundDevices(),
                             tr("%1 times a second").arg(servo),
                             measured,
                             m_facts.stationKey.left(kKeyShown),
                             m_facts.database,
                             tr("%n attempt(s)", nullptr, m_facts.waiting),
                             QStringLiteral("Cusp %1, Qt %2").arg(m_facts.program, QString::fromLatin1(qVersion()))};
    for (int row = 0; row < kRows; ++row) {
        m_names[row]->setText(names[row]);
        m_values[row]->setText(values[row]);
    }
}

void StationPart::setFacts(const Facts& facts)
{
    m_facts = facts;
    retranslateUi();
}

void StationPart::setIdleMinutes(int minutes)
{
    m_idleMinutes = minutes;
    m_idle->setValue(minutes);
}

}  // namespace ui::admin
