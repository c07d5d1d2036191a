// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/StereoCard.h"

#include <cmath>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::practice {
namespace {

constexpr double kPerMille = 0.001;
constexpr int kCardPx = 460;

QSlider* slider(int low, int high, QWidget* parent)
{
    auto* made = new QSlider(Qt::Horizontal, parent);
    made->setRange(low, high);
    made->setPageStep((high - low) / 10);
    return made;
}

QLabel* words(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    return label;
}

}  // namespace

StereoCard::StereoCard(QWidget* parent)
    : QFrame(parent), m_mode(new QComboBox(this)), m_apart(slider(5, 100, this)), m_convergence(slider(600, 1600, this))
{
    setProperty("kind", "card");
    setFixedWidth(kCardPx);
    m_mode->addItems({{}, {}, {}, {}});
    auto* title = new QLabel(this);
    title->setFont(kit::typeface(kit::kTitle, QFont::DemiBold));
    auto* ready = new QPushButton(this);
    ready->setProperty("kind", "filled");
    auto* off = new QPushButton(this);
    auto* back = new QPushButton(this);
    back->setObjectName(QStringLiteral("cancelStereo"));
    ready->setObjectName(QStringLiteral("keepStereo"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(kit::kSpace4, kit::kSpace4, kit::kSpace4, kit::kSpace4);
    grid->setVerticalSpacing(kit::kSpace2);
    int row = 0;
    grid->addWidget(title, row++, 0, 1, 2);
    auto* first = words(this);
    auto* second = words(this);
    auto* third = words(this);
    grid->addWidget(first, row++, 0, 1, 2);
    grid->addWidget(m_mode, row++, 0, 1, 2);
    grid->addWidget(second, row++, 0, 1, 2);
    grid->addWidget(m_apart, row++, 0, 1, 2);
    grid->addWidget(third, row++, 0, 1, 2);
    grid->addWidget(m_convergence, row++, 0, 1, 2);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kit::kSpace2);
    buttons->addWidget(off);
    buttons->addStretch(1);
    buttons->addWidget(back);
    buttons->addWidget(ready);
    grid->addLayout(buttons, row, 0, 1, 2);
    text::bindTranslation(this, [this, title, first, second, third, ready, off, back] {
        setAccessibleName(tr("Stereo picture"));
        title->setText(tr("Stereo picture"));
        m_mode->setAccessibleName(tr("Way to the eyes"));
        int mode = 0;
        for (const QString& way : {tr("Red and cyan glasses, in colour"), tr("Red and cyan glasses, in grey"),
                                   tr("Halves side by side"), tr("Halves one above the other")})
            m_mode->setItemText(mode++, way);
        m_apart->setAccessibleName(tr("Distance of the eyes"));
        m_convergence->setAccessibleName(tr("Plane of the screen"));
        first->setText(tr("1. How do the two pictures reach your eyes? Close one eye, then the other: each must see "
                          "a single tooth."));
        second->setText(tr("2. Move the eyes apart until the cusps stand up from the fissures, and back a little if it "
                           "tires you."));
        third->setText(tr("3. Move the tooth before or behind the screen until you see it without effort."));
        ready->setText(tr("Done"));
        off->setText(tr("Without stereo"));
        back->setText(tr("Cancel"));
        back->setToolTip(tr("Discard the changes (Esc)"));
        if (isVisible())
            adjustSize();
    });
    connect(m_mode, &QComboBox::currentIndexChanged, this, &StereoCard::tell);
    connect(m_apart, &QSlider::valueChanged, this, &StereoCard::tell);
    connect(m_convergence, &QSlider::valueChanged, this, &StereoCard::tell);
    connect(back, &QPushButton::clicked, this, &StereoCard::cancel);
    connect(ready, &QPushButton::clicked, this, &StereoCard::done);
    connect(off, &QPushButton::clicked, this, [this] {
        emit changed(render::Stereo::Off, m_apart->value() * kPerMille, m_convergence->value() * kPerMille);
        emit done();
    });
    hide();
}

void StereoCard::open(const render::Presentation& now, render::Stereo way)
{
    // If the card is already open, Cancel still restores the settings from before.
    if (isHidden()) {
        m_before = now;
        m_wayBefore = way;
    }
    {
        const QSignalBlocker quiet(this);
        m_mode->setCurrentIndex(static_cast<int>(now.stereo == render::Stereo::Off ? way : now.stereo) - 1);
        m_apart->setValue(static_cast<int>(std::lround(now.apart / kPerMille)));
        m_convergence->setValue(static_cast<int>(std::lround(now.convergence / kPerMille)));
    }
    adjustSize();
    show();
    raise();
    m_mode->setFocus();
    tell();
}

void StereoCard::cancel()
{
    // Restores the stereo mode first. It stays for the next time even if stereo was off.
    emit changed(m_wayBefore, m_before.apart, m_before.convergence);
    emit changed(m_before.stereo, m_before.apart, m_before.convergence);
    emit done();
}

void StereoCard::tell()
{
    emit changed(static_cast<render::Stereo>(m_mode->currentIndex() + 1), m_apart->value() * kPerMille,
                 m_convergence->value() * kPerMille);
}

}  // namespace ui::practice
