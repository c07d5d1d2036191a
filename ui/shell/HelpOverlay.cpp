// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/HelpOverlay.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/shell/Actions.h"
#include "ui/shell/LineIcon.h"
#include "ui/shell/Theme.h"

namespace ui::shell {
namespace {

struct Gesture
{
    QString doing;
    QStringList with;
};

/// What has no action because the view itself listens for it (ui/tooth/ToothView).
QList<Gesture> gestures()
{
    return {
        {HelpOverlay::tr("Move the bur"), {HelpOverlay::tr("mouse"), HelpOverlay::tr("arrows")}},
        {HelpOverlay::tr("Move it finely"), {HelpOverlay::tr("Shift + arrows")}},
        {HelpOverlay::tr("Push it against the tooth"), {HelpOverlay::tr("left button"), HelpOverlay::tr("Page Down")}},
        {HelpOverlay::tr("Lift it"), {HelpOverlay::tr("Page Up")}},
        {HelpOverlay::tr("Push harder, softer"),
         {HelpOverlay::tr("Ctrl + wheel"), QStringLiteral("."), QStringLiteral(",")}},
        {HelpOverlay::tr("Turn the view"), {HelpOverlay::tr("right or middle drag"), HelpOverlay::tr("Ctrl + arrows")}},
        {HelpOverlay::tr("Turn the handpiece"), {HelpOverlay::tr("the same with Shift")}},
        // The left button on the tooth drills, however quickly it is pressed twice.
        {HelpOverlay::tr("Turn it back"), {HelpOverlay::tr("right double-click"), HelpOverlay::tr("Home")}},
        {HelpOverlay::tr("Come nearer, go back"), {HelpOverlay::tr("wheel"), QStringLiteral("+"), QStringLiteral("−")}},
    };
}

QLabel* heading(const QString& words, QWidget* parent)
{
    auto* label = new QLabel(words, parent);
    label->setFont(typeface(kBody, QFont::DemiBold));
    return label;
}

QLabel* keyCap(const QString& words, QWidget* parent)
{
    auto* cap = new QLabel(words, parent);
    cap->setProperty("kind", "key");
    return cap;
}

QWidget* rowOf(QWidget* parent, const QString& words, const QStringList& keys)
{
    auto* whole = new QWidget(parent);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace1);
    row->addWidget(new QLabel(words, whole), 1);
    for (const QString& key : keys)
        row->addWidget(keyCap(key, whole));
    return whole;
}

}  // namespace

HelpOverlay::HelpOverlay(const Actions& actions, QWidget* parent)
    : QWidget(parent), m_card(new QFrame(this)), m_close(new QToolButton(this))
{
    setAccessibleName(actions.help->text());
    m_card->setProperty("kind", "card");

    auto* title = new QLabel(actions.help->text(), m_card);
    title->setFont(typeface(kTitle, QFont::DemiBold));
    m_close->setIcon(lineIcon(QStringLiteral("close"), palette()));
    m_close->setAccessibleName(tr("Close"));
    m_close->setToolTip(tr("Close (Esc)"));
    connect(m_close, &QToolButton::clicked, actions.back, &QAction::trigger);
    connect(this, &HelpOverlay::leftByClick, actions.back, &QAction::trigger);
    auto* head = new QHBoxLayout;
    head->addWidget(title, 1);
    head->addWidget(m_close);

    // Two columns; each group goes whole into the shorter one.
    auto* content = new QWidget(m_card);
    auto* columns = new QHBoxLayout(content);
    columns->setContentsMargins(0, 0, kSpace2, 0);
    columns->setSpacing(2 * kSpace6);
    QList<QVBoxLayout*> column;
    QList<qsizetype> filled{0, 0};
    for (int k = 0; k < 2; ++k) {
        column.push_back(new QVBoxLayout);
        column[k]->setSpacing(kSpace1);
        columns->addLayout(column[k], 1);
    }
    qsizetype lastFilled = 0;
    const auto place = [&](const QString& words, const QList<QWidget*>& rows) {
        const qsizetype k = filled[0] <= filled[1] ? 0 : 1;
        lastFilled = k;
        if (filled[k] > 0)
            column[k]->addSpacing(kSpace4);
        column[k]->addWidget(heading(words, content));
        for (QWidget* row : rows)
            column[k]->addWidget(row);
        filled[k] += rows.size() + 2;
    };
    for (const Actions::Group& group : actions.groups()) {
        QList<QWidget*> rows;
        for (const QAction* action : group.actions) {
            QStringList keys;
            for (const QKeySequence& key : action->shortcuts())
                keys << key.toString(QKeySequence::NativeText);
            rows << rowOf(content, action->text(), keys);
            QWidget* row = rows.back();
            const auto follow = [row, action] { row->setVisible(action->isVisible()); };
            follow();
            connect(action, &QAction::visibleChanged, row, follow);
        }
        place(group.title, rows);
    }
    QList<QWidget*> rows;
    for (const Gesture& gesture : gestures())
        rows << rowOf(content, gesture.doing, gesture.with);
    place(tr("Over the tooth"), rows);
    auto* force =
        new QLabel(tr("The teal arc beside the bur shows how hard it presses; it is full at the force that is "
                      "set."),
                   content);
    force->setWordWrap(true);
    force->setForegroundRole(QPalette::PlaceholderText);
    column[lastFilled]->addSpacing(kSpace1);
    column[lastFilled]->addWidget(force);
    for (QVBoxLayout* each : column)
        each->addStretch(1);

    auto* scroll = new QScrollArea(m_card);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);

    auto* inside = new QVBoxLayout(m_card);
    inside->setContentsMargins(kSpace6, kSpace4, kSpace4, kSpace6);
    inside->setSpacing(kSpace4);
    inside->addLayout(head);
    inside->addWidget(scroll, 1);

    // As tall as its content, where the window has the room.
    m_card->setMaximumSize(960, content->sizeHint().height() + title->sizeHint().height() + 5 * kSpace4 + kSpace6);
    m_card->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto* centre = new QGridLayout(this);
    centre->setContentsMargins(2 * kSpace6, 2 * kSpace6, 2 * kSpace6, 2 * kSpace6);
    centre->addWidget(m_card, 0, 0);
    hide();
}

void HelpOverlay::paintEvent(QPaintEvent*)
{
    QPainter(this).fillRect(rect(), QColor(0, 0, 0, 150));
}

void HelpOverlay::mousePressEvent(QMouseEvent* event)
{
    if (!m_card->geometry().contains(event->pos()))
        emit leftByClick();
}

void HelpOverlay::showEvent(QShowEvent* event)
{
    m_close->setFocus();
    QWidget::showEvent(event);
}

}  // namespace ui::shell
