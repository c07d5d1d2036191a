// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/HelpOverlay.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/Actions.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::window {
namespace {

constexpr int kMostColumns = 3;
constexpr int kColumnGapPx = 32;
constexpr int kColumnPx = 330;  ///< smallest width of a column
constexpr int kWidestColumnPx = 400;
constexpr int kScrollBarPx = 16;

struct Gesture
{
    QString doing;
    QStringList with;
};

/// Returns the input that ui/tooth/ToothView handles itself, so that there are no actions for it.
QList<Gesture> gestures()
{
    return {
        {HelpOverlay::tr("Move the bur"), {HelpOverlay::tr("mouse"), HelpOverlay::tr("arrows")}},
        {HelpOverlay::tr("Move it in fine steps"), {HelpOverlay::tr("Shift + arrows")}},
        {HelpOverlay::tr("Push it against the tooth"), {HelpOverlay::tr("left button"), HelpOverlay::tr("Page Down")}},
        {HelpOverlay::tr("Lift it"), {HelpOverlay::tr("Page Up")}},
        {HelpOverlay::tr("Push harder, softer"),
         {HelpOverlay::tr("Ctrl + wheel"), QStringLiteral("."), QStringLiteral(",")}},
        {HelpOverlay::tr("Depth stop"),
         {HelpOverlay::tr("wheel while pressed"), HelpOverlay::tr("Shift + wheel"), HelpOverlay::tr("Insert, Delete")}},
        {HelpOverlay::tr("Turn the view"), {HelpOverlay::tr("right or middle drag"), HelpOverlay::tr("Ctrl + arrows")}},
        {HelpOverlay::tr("Turn the handpiece"), {HelpOverlay::tr("the same with Shift")}},
        // A double-click with the left button drills, so it cannot reset the view.
        {HelpOverlay::tr("Reset view"), {HelpOverlay::tr("right double-click"), HelpOverlay::tr("Home")}},
        {HelpOverlay::tr("Move the mirror"), {HelpOverlay::tr("drag its glass"), HelpOverlay::tr("Alt + arrows")}},
        {HelpOverlay::tr("Tilt the mirror"), {HelpOverlay::tr("the same with Shift")}},
        {HelpOverlay::tr("Bring it nearer"), {HelpOverlay::tr("wheel over it"), HelpOverlay::tr("Alt + Page Up")}},
        {HelpOverlay::tr("Zoom in, zoom out"), {HelpOverlay::tr("wheel"), QStringLiteral("+"), QStringLiteral("−")}},
    };
}

/// Returns the input that ui/kit/ListTable handles itself.
QList<Gesture> inLists()
{
    return {
        {HelpOverlay::tr("Change the sorting"), {HelpOverlay::tr("Alt + arrows")}},
    };
}

QLabel* heading(const QString& words, QWidget* parent)
{
    auto* label = new QLabel(words, parent);
    label->setFont(kit::typeface(kit::kBody, QFont::DemiBold));
    return label;
}

QLabel* keyCap(const QString& words, QWidget* parent)
{
    auto* cap = new QLabel(words, parent);
    cap->setProperty("kind", "key");
    return cap;
}

QWidget* rowOf(QWidget* parent, QLabel* doing, const QStringList& keys)
{
    auto* whole = new QWidget(parent);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kit::kSpace1);
    doing->setWordWrap(true);
    row->addWidget(doing, 1);
    for (const QString& key : keys)
        row->addWidget(keyCap(key, whole));
    return whole;
}

}  // namespace

HelpOverlay::HelpOverlay(const kit::Actions& actions, QWidget* parent)
    : QWidget(parent), m_card(new QFrame(this)), m_close(new QToolButton(this)), m_content(new QWidget(m_card))
{
    m_card->setProperty("kind", "card");

    auto* title = new QLabel(m_card);
    kit::followWords(actions.help, this, [this, title, action = actions.help] {
        setAccessibleName(action->text());
        title->setText(action->text());
    });
    title->setFont(kit::typeface(kit::kTitle, QFont::DemiBold));
    m_close->setIcon(kit::lineIcon(QStringLiteral("close"), palette()));
    text::bindTranslation(m_close, [this] {
        m_close->setAccessibleName(tr("Close"));
        m_close->setToolTip(tr("Close (Esc)"));
    });
    connect(m_close, &QToolButton::clicked, actions.back, &QAction::trigger);
    connect(this, &HelpOverlay::leftByClick, actions.back, &QAction::trigger);
    auto* head = new QHBoxLayout;
    head->addWidget(title, 1);
    head->addWidget(kit::pageButton(actions.tour, "", m_card));
    head->addWidget(m_close);

    auto* inside = new QVBoxLayout(m_card);
    inside->setContentsMargins(kit::kSpace6, kit::kSpace2, kit::kSpace4, kit::kSpace4);
    inside->setSpacing(kit::kSpace2);
    inside->addLayout(head);
    m_scroll = new kit::ScrollPane(m_content, QPalette::Base, m_card);
    inside->addWidget(m_scroll, 1);
    // The groups are made again in another language, because the keys have other names too.
    text::bindTranslation(this, [this, &actions] { makeGroups(actions); });
    connect(&actions, &kit::Actions::bursAtHandChanged, this, [this, &actions] { makeGroups(actions); });
    hide();
}

void HelpOverlay::makeGroups(const kit::Actions& actions)
{
    delete m_content->layout();
    qDeleteAll(std::exchange(m_groups, {}));
    m_columns = 0;
    const auto place = [this](const QString& words, const QList<QWidget*>& rows) {
        auto* group = new QWidget(m_content);
        auto* lines = new QVBoxLayout(group);
        lines->setContentsMargins(0, 0, 0, kit::kSpace2);
        lines->setSpacing(kit::kSpace1);
        lines->addWidget(heading(words, group));
        for (QWidget* row : rows)
            lines->addWidget(row);
        m_groups << group;
    };
    for (const kit::Actions::Group& group : actions.groups()) {
        QList<QWidget*> rows;
        QList<QAction*> keyed = group.actions;
        keyed.removeIf([](const QAction* action) { return action->shortcuts().isEmpty(); });
        for (QAction* action : std::as_const(keyed)) {
            QStringList keys;
            for (const QKeySequence& key : action->shortcuts())
                keys << key.toString(QKeySequence::NativeText);
            // The text of some actions changes: the same keys log in and lock.
            auto* doing = new QLabel(m_content);
            kit::followWords(action, doing, [doing, action] { doing->setText(action->text()); });
            rows << rowOf(m_content, doing, keys);
        }
        place(group.title(), rows);
        const auto follow = [this, heads = m_groups.back(), rows, actions = keyed] {
            bool any = false;
            for (qsizetype k = 0; k < rows.size(); ++k) {
                rows[k]->setVisible(actions[k]->isVisible());
                any = any || actions[k]->isVisible();
            }
            heads->setVisible(any);
            m_columns = 0;
        };
        follow();
        for (const QAction* action : std::as_const(keyed))
            connect(action, &QAction::visibleChanged, m_groups.back(), follow);
    }
    const auto rowsOf = [this](const QList<Gesture>& all) {
        QList<QWidget*> rows;
        for (const Gesture& gesture : all)
            rows << rowOf(m_content, new QLabel(gesture.doing), gesture.with);
        return rows;
    };
    place(tr("In a list"), rowsOf(inLists()));
    QList<QWidget*> rows = rowsOf(gestures());
    auto* force =
        new QLabel(tr("The teal arc beside the bur shows how hard it presses; it is full at the force that is "
                      "set."),
                   m_content);
    force->setWordWrap(true);
    force->setForegroundRole(QPalette::PlaceholderText);
    rows << force;
    place(tr("Over the tooth"), rows);
    if (isVisible())
        arrange();
}

/// Arranges the groups, in their order, in columns of about the same height. The card becomes as tall as the columns,
/// if the window has room for that.
void HelpOverlay::arrange()
{
    const QMargins around = m_card->layout()->contentsMargins();
    const QSize room = size() - QSize(2 * kit::kSpace6, 2 * kit::kSpace6);
    const int chromePx = around.left() + around.right() + kScrollBarPx;
    const int columns =
        std::clamp((room.width() - chromePx + kColumnGapPx) / (kColumnPx + kColumnGapPx), 1, kMostColumns);
    if (columns != std::exchange(m_columns, columns))
        fill(columns);
    const int widest = columns * kWidestColumnPx + (columns - 1) * kColumnGapPx + chromePx;
    const int width = std::min(room.width(), widest);
    const int rest = m_card->sizeHint().height() - m_scroll->sizeHint().height();
    const int wanted = rest + m_content->layout()->totalHeightForWidth(width - chromePx);
    const QSize card(width, std::min(room.height(), wanted));
    m_card->setGeometry(QRect(QPoint((this->width() - card.width()) / 2, (height() - card.height()) / 2), card));
}

void HelpOverlay::fill(int columns)
{
    delete m_content->layout();
    auto* row = new QHBoxLayout(m_content);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kColumnGapPx);
    int left = 0;
    QList<QWidget*> groups;
    for (QWidget* group : m_groups)
        if (!group->isHidden())
            groups << group;
    for (const QWidget* group : groups)
        left += group->sizeHint().height();
    qsizetype next = 0;
    for (int k = columns; k > 0; --k) {
        auto* column = new QVBoxLayout;
        column->setSpacing(0);
        row->addLayout(column, 1);
        const int share = left / k;
        for (int filled = 0; next < groups.size(); ++next) {
            const int height = groups[next]->sizeHint().height();
            // The column ends where its height is nearest to the share: before this group or after it.
            if (k > 1 && filled > 0 && filled + height - share > share - filled)
                break;
            column->addWidget(groups[next]);
            filled += height;
            left -= height;
        }
        column->addStretch(1);
    }
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

void HelpOverlay::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void HelpOverlay::showEvent(QShowEvent* event)
{
    arrange();
    m_close->setFocus();
    QWidget::showEvent(event);
}

}  // namespace ui::window
