// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/StereoCard.h"

#include <cmath>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include "ui/shell/Theme.h"

namespace ui::shell {
namespace {

constexpr double kPerMille = 0.001;
constexpr int kCardPx = 460;

QSlider* slider(int low, int high, const QString& name, QWidget* parent)
{
    auto* made = new QSlider(Qt::Horizontal, parent);
    made->setRange(low, high);
    made->setPageStep((high - low) / 10);
    made->setAccessibleName(name);
    return made;
}

QLabel* words(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    return label;
}

}  // namespace

StereoCard::StereoCard(QWidget* parent)
    : QFrame(parent), m_mode(new QComboBox(this)), m_apart(slider(5, 100, tr("Distance of the eyes"), this)),
      m_convergence(slider(600, 1600, tr("Plane of the screen"), this))
{
    setProperty("kind", "card");
    setAccessibleName(tr("Stereo picture"));
    setFixedWidth(kCardPx);
    m_mode->setAccessibleName(tr("Way to the eyes"));
    for (const QString& mode : {tr("Red and cyan glasses, in colour"), tr("Red and cyan glasses, in grey"),
                                tr("Halves side by side"), tr("Halves one above the other")})
        m_mode->addItem(mode);
    auto* title = new QLabel(tr("Stereo picture"), this);
    title->setFont(typeface(kTitle, QFont::DemiBold));
    auto* ready = new QPushButton(tr("Done"), this);
    ready->setProperty("kind", "filled");
    auto* off = new QPushButton(tr("Without stereo"), this);
    auto* back = new QPushButton(tr("Cancel"), this);
    back->setToolTip(tr("Leave everything as it was before (Esc)"));
    back->setObjectName(QStringLiteral("cancelStereo"));
    ready->setObjectName(QStringLiteral("keepStereo"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    grid->setVerticalSpacing(kSpace2);
    int row = 0;
    grid->addWidget(title, row++, 0, 1, 2);
    grid->addWidget(words(tr("1. How do the two pictures reach your eyes? Close one eye, then the other: each must see "
                             "a single tooth."),
                          this),
                    row++, 0, 1, 2);
    grid->addWidget(m_mode, row++, 0, 1, 2);
    grid->addWidget(
        words(tr("2. Move the eyes apart until the cusps stand up from the fissures, and back a little if it "
                 "tires you."),
              this),
        row++, 0, 1, 2);
    grid->addWidget(m_apart, row++, 0, 1, 2);
    grid->addWidget(words(tr("3. Move the tooth before or behind the screen until you see it without effort."), this),
                    row++, 0, 1, 2);
    grid->addWidget(m_convergence, row++, 0, 1, 2);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kSpace2);
    buttons->addWidget(off);
    buttons->addStretch(1);
    buttons->addWidget(back);
    buttons->addWidget(ready);
    grid->addLayout(buttons, row, 0, 1, 2);
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
    // Asked for again while it is open, it still knows the way back.
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
    // The way to the eyes first, which stays for the next time where stereo was off.
    emit changed(m_wayBefore, m_before.apart, m_before.convergence);
    emit changed(m_before.stereo, m_before.apart, m_before.convergence);
    emit done();
}

void StereoCard::tell()
{
    emit changed(static_cast<render::Stereo>(m_mode->currentIndex() + 1), m_apart->value() * kPerMille,
                 m_convergence->value() * kPerMille);
}

}  // namespace ui::shell
