// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/toothchooser/ToothChooser.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/toothchooser/ArchView.h"
#include "ui/toothchooser/Mouth.h"

namespace ui::toothchooser {
namespace {

constexpr int kCardWidthPx = 380;
constexpr int kGapPx = 64;
constexpr int kNarrowPx = 960;
constexpr int kWidestArchesPx = 600;

}  // namespace

ToothChooser::ToothChooser(const kit::Actions& actions, QWidget* parent)
    : kit::Page(actions, parent), m_pictures(new QStackedWidget(this)), m_row(new QHBoxLayout),
      m_gap(new QSpacerItem(kGapPx, 0)), m_arches(new ArchView(m_pictures)), m_number(new QLabel(this)),
      m_name(new QLabel(this)), m_note(new QLabel(this)), m_take(new QPushButton(this)),
      m_other(kit::pageButton(actions.mouth, "", this))
{
    m_pictures->addWidget(m_arches);
    m_pictures->setMaximumWidth(kWidestArchesPx);
    m_number->setFont(kit::typeface(kit::kHero, QFont::DemiBold));
    m_name->setFont(kit::typeface(kit::kTitle, QFont::Medium));
    m_name->setWordWrap(true);
    m_note->setForegroundRole(QPalette::PlaceholderText);
    m_note->setWordWrap(true);
    m_take->setProperty("kind", "filled");
    m_take->setFocusPolicy(Qt::TabFocus);
    m_take->setAutoDefault(true);
    m_take->setObjectName(QStringLiteral("takeTooth"));

    connect(actions.mouth, &QAction::visibleChanged, m_other,
            [this, action = actions.mouth] { m_other->setVisible(action->isVisible()); });

    auto* scanHint = new QLabel(this);
    scanHint->setWordWrap(true);
    scanHint->setForegroundRole(QPalette::PlaceholderText);

    auto* words = new QVBoxLayout;
    words->setSpacing(kit::kSpace1);
    words->addStretch(1);
    words->addWidget(m_number);
    words->addWidget(m_name);
    words->addWidget(m_note);
    words->addSpacing(kit::kSpace4);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kit::kSpace2);
    buttons->addWidget(m_take);
    buttons->addWidget(m_other);
    buttons->addStretch(1);
    words->addLayout(buttons);
    words->addSpacing(kit::kSpace6);
    words->addWidget(kit::line(this));
    words->addSpacing(kit::kSpace2);
    words->addWidget(scanHint);
    words->addSpacing(kit::kSpace2);
    words->addWidget(kit::pageButton(actions.openScan, "", this), 0, Qt::AlignLeft);
    words->addStretch(1);
    auto* side = new QWidget(this);
    side->setFixedWidth(kCardWidthPx);
    side->setLayout(words);

    m_row->addStretch(1);
    m_row->addWidget(m_pictures, 4);
    m_row->addItem(m_gap);
    m_row->addWidget(side);
    m_row->addStretch(1);
    body()->addLayout(m_row, 1);

    connect(m_arches, &ArchView::selectionChanged, this, &ToothChooser::describe);
    connect(m_arches, &ArchView::toothActivated, this, &ToothChooser::toothChosen);
    connect(m_take, &QPushButton::clicked, this, [this] { emit toothChosen(m_arches->selected()); });
    text::bindTranslation(this, [this, scanHint] {
        setTitle(tr("Choose a tooth"));
        m_take->setText(tr("Drill this tooth"));
        m_take->setAccessibleName(m_take->text());
        m_take->setToolTip(tr("Practise on this tooth (Enter)"));
        scanHint->setText(tr("Or drill your own tooth: a scan as an OBJ, STL or PLY file. You can also drop the file "
                             "anywhere on this window."));
        sayOther();
        describe(m_arches->selected());
    });
}

void ToothChooser::sayOther()
{
    m_other->setText(m_mouthShown ? tr("Flat arches") : tr("Whole mouth"));
    m_other->setAccessibleName(m_other->text());
}

void ToothChooser::setPresent(int fdi)
{
    m_present = fdi;
    m_arches->setSelected(fdi);
    if (m_mouth != nullptr)
        m_mouth->setSelected(fdi);
    describe(m_arches->selected());
}

void ToothChooser::showMouth(bool inSpace)
{
    if (inSpace && m_mouth == nullptr) {
        m_mouth = new Mouth(m_pictures);
        m_mouth->setMovesLittle(m_movesLittle);
        m_pictures->addWidget(m_mouth);
        connect(m_mouth, &Mouth::selectionChanged, this, [this](int fdi) {
            m_arches->setSelected(fdi);
            describe(fdi);
        });
        connect(m_mouth, &Mouth::toothActivated, this, &ToothChooser::toothChosen);
    }
    m_mouthShown = inSpace;
    sayOther();
    if (inSpace)
        m_mouth->setSelected(m_arches->selected());
    // The mouth uses all the room available.
    m_pictures->setMaximumWidth(inSpace ? QWIDGETSIZE_MAX : kWidestArchesPx);
    m_row->setStretch(0, inSpace ? 0 : 1);
    m_row->setStretch(m_row->count() - 1, inSpace ? 0 : 1);
    m_pictures->setCurrentWidget(inSpace ? static_cast<QWidget*>(m_mouth) : m_arches);
    takeFocus();
}

void ToothChooser::setMovesLittle(bool little)
{
    m_movesLittle = little;
    if (m_mouth != nullptr)
        m_mouth->setMovesLittle(little);
}

void ToothChooser::takeFocus()
{
    if (m_mouthShown)
        m_mouth->setFocus();
    else
        m_arches->takeFocus();
}

void ToothChooser::resizeEvent(QResizeEvent* event)
{
    kit::Page::resizeEvent(event);
    m_gap->changeSize(width() < kNarrowPx ? kit::kSpace6 : kGapPx, 0);
    m_row->invalidate();
}

void ToothChooser::showEvent(QShowEvent* event)
{
    setPresent(m_present);
    kit::Page::showEvent(event);
    takeFocus();
}

void ToothChooser::describe(int fdi)
{
    m_number->setText(fdi == 0 ? QStringLiteral("–") : QString::number(fdi));
    m_name->setText(fdi == 0 ? tr("No tooth selected") : text::capitalised(text::toothName(fdi)));
    m_note->setText(fdi != 0 && fdi == m_present ? tr("In use. Choosing it again resets it.")
                                                 : tr("Click a tooth, or use the arrow keys."));
    m_take->setEnabled(fdi != 0);
}

}  // namespace ui::toothchooser
