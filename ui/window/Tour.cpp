// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/Tour.h"

#include <algorithm>
#include <array>

#include <QAction>
#include <QApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/Accessibility.h"
#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"
#include "ui/practice/SidePanel.h"
#include "ui/text/EveryLanguage.h"
#include "ui/tooth/ToothView.h"

namespace ui::window {
namespace {

constexpr int kTourCardPx = 360;
constexpr int kTourGapPx = 14;  ///< distance between the card and the target
constexpr int kAroundPx = 4;    ///< width of the highlighted border around the target
constexpr int kLiftPx = 72;     ///< distance of a card on the target from the lower edge of the target

/// Returns the visible button of an action on a page; null if there is none.
QWidget* buttonOf(const QWidget& page, const QAction* action)
{
    for (auto* button : page.findChildren<QToolButton*>())
        if (button->defaultAction() == action && button->isVisibleTo(&page))
            return button;
    for (auto* button : page.findChildren<QPushButton*>())
        if (button->text() == action->text() && button->isVisibleTo(&page))
            return button;
    return nullptr;
}

}  // namespace

Tour::Tour(const kit::Actions& actions, const Pages& pages, QWidget* parent)
    : QWidget(parent), m_actions(actions), m_pages(pages), m_card(new QFrame(this)), m_title(new QLabel(m_card)),
      m_words(new QLabel(m_card)), m_count(new QLabel(m_card)), m_skip(new QPushButton(m_card)),
      m_back(new QPushButton(m_card)), m_next(new QPushButton(m_card))
{
    setObjectName(QStringLiteral("tour"));
    m_card->setProperty("kind", "card");
    m_title->setFont(kit::typeface(kit::kTitle, QFont::DemiBold));
    m_title->setObjectName(QStringLiteral("tourTitle"));
    m_words->setFont(kit::typeface(kit::kBody));
    m_words->setObjectName(QStringLiteral("tourWords"));
    m_count->setFont(kit::typeface(kit::kSmall));
    m_count->setObjectName(QStringLiteral("tourCount"));
    m_count->setForegroundRole(QPalette::PlaceholderText);
    for (QLabel* label : {m_title, m_words, m_count})
        label->setTextFormat(Qt::PlainText);
    for (QLabel* label : {m_title, m_words})
        label->setWordWrap(true);
    m_skip->setObjectName(QStringLiteral("tourSkip"));
    m_skip->setProperty("kind", "quiet");
    m_back->setObjectName(QStringLiteral("tourBack"));
    m_next->setObjectName(QStringLiteral("tourNext"));
    m_next->setProperty("kind", "filled");
    for (QPushButton* button : {m_skip, m_back, m_next}) {
        button->setAutoDefault(true);
        button->installEventFilter(this);
    }
    connect(m_skip, &QPushButton::clicked, this, &Tour::end);
    connect(m_back, &QPushButton::clicked, this, &Tour::previous);
    connect(m_next, &QPushButton::clicked, this, &Tour::next);
    auto* column = new QVBoxLayout(m_card);
    column->setContentsMargins(kit::kSpace6, kit::kSpace4, kit::kSpace4, kit::kSpace4);
    column->setSpacing(kit::kSpace2);
    column->addWidget(m_title);
    column->addWidget(m_words);
    column->addSpacing(kit::kSpace1);
    column->addWidget(m_count);
    auto* row = new QHBoxLayout;
    row->setSpacing(kit::kSpace2);
    row->addWidget(m_skip);
    row->addStretch(1);
    row->addWidget(m_back);
    row->addWidget(m_next);
    column->addLayout(row);
    hide();
    // A page that is filled during the tour may take the keyboard focus, so the tour takes it back.
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        if (!isHidden() && now != nullptr && parentWidget()->isAncestorOf(now) && !isAncestorOf(now))
            m_next->setFocus();
    });
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void Tour::add(Where where, QWidget* target, const char* title, const char* words)
{
    if (target != nullptr)
        m_steps.push_back({where, target, title, words});
}

void Tour::add(Where where, QAction* action, const char* title, const char* words)
{
    add(where, buttonOf(page(where), action), title, words);
}

const QWidget& Tour::page(Where where) const
{
    switch (where) {
    case Where::Lessons:
        return m_pages.lessons;
    case Where::Classes:
        return m_pages.classes;
    case Where::School:
        return m_pages.school;
    case Where::Room:
        break;
    }
    return m_pages.room;
}

void Tour::addDrilling(const char* title)
{
    add(Where::Room, m_pages.room.findChild<tooth::ToothView*>(), title,
        QT_TR_NOOP("Move the bur with the mouse and press the left button to drill. Drag with the right button to turn "
                   "the view."));
}

void Tour::begin(database::Role role)
{
    using database::Role;
    m_steps.clear();
    if (role == Role::Instructor) {
        add(Where::Classes, m_actions.classes, QT_TR_NOOP("Your classes"),
            QT_TR_NOOP("Here you see who needs help and how everybody is doing. Assign lessons, open attempts, replay "
                       "them, and write comments."));
        add(Where::Lessons, m_pages.lessons.findChild<QListView*>(QStringLiteral("lessonList")),
            QT_TR_NOOP("All lessons"),
            QT_TR_NOOP("The lessons that come with Cusp, and your own. Search for a word or the number of a tooth."));
        add(Where::Lessons, m_actions.editLesson, QT_TR_NOOP("Change a lesson"),
            QT_TR_NOOP("Change the goal and the rubric of a lesson, and see the effect on earlier attempts."));
        addDrilling(QT_TR_NOOP("Try it yourself"));
        add(Where::Room, m_actions.grade, QT_TR_NOOP("The grade"),
            QT_TR_NOOP("Your work is measured, and the score card shows where and when each point was lost."));
    } else if (role == Role::Admin) {
        add(Where::School, m_actions.school, QT_TR_NOOP("The school"),
            QT_TR_NOOP(
                "Add people one by one or from a list, assign them to classes, and manage backups and the audit."));
        add(Where::School, m_actions.classes, QT_TR_NOOP("Classes"),
            QT_TR_NOOP("The results of every class in every lesson, as its teachers see them."));
        addDrilling(QT_TR_NOOP("Try it yourself"));
        add(Where::Room, m_pages.room.findChild<practice::SidePanel*>(), QT_TR_NOOP("How it feels"),
            QT_TR_NOOP("Burs, force and depth are here. The hardness presets (F7) set how hard teeth are."));
    } else {
        addDrilling(QT_TR_NOOP("The tooth"));
        if (role == Role::Student)
            add(Where::Lessons, m_pages.lessons.findChild<QListView*>(QStringLiteral("lessonList")),
                QT_TR_NOOP("Lessons"),
                QT_TR_NOOP("Choose here what to practise. Lessons assigned to your class come first."));
        else
            add(Where::Room, m_actions.lessons, QT_TR_NOOP("Lessons"),
                QT_TR_NOOP("Choose here what to practise. Each lesson states its goal and how it is graded."));
        add(Where::Room, m_pages.room.findChild<practice::SidePanel*>(), QT_TR_NOOP("Bur, force and depth"),
            QT_TR_NOOP("Change the bur, set how hard the mouse presses, and read force and depth while you drill."));
        add(Where::Room, m_actions.section, QT_TR_NOOP("Seeing inside"),
            QT_TR_NOOP("A live section through the bur shows enamel, dentin and pulp, where the lesson allows it."));
        add(Where::Room, m_actions.grade, QT_TR_NOOP("The grade"),
            QT_TR_NOOP("Your work is measured, and the score card shows where and when each point was lost."));
        if (role == Role::Student)
            add(Where::Lessons, m_actions.attempts, QT_TR_NOOP("My attempts"),
                QT_TR_NOOP("See how your scores develop, read your instructor's comments, and replay every attempt."));
    }
    if (role != Role::Student)
        add(Where::Room, m_actions.account, QT_TR_NOOP("Your account"),
            role == Role::Guest ? QT_TR_NOOP("Log in to save your grades. Without a login, nothing is saved.")
                                : QT_TR_NOOP("Lock the window when you leave, or switch user."));
    add(Where::Room, m_actions.help, QT_TR_NOOP("Every key"),
        QT_TR_NOOP("All keys are listed here. You can also start this tour again from there."));
    if (m_steps.empty())
        return;
    m_step = 0;
    QWidget::show();
    show(0);
}

QWidget* Tour::target() const
{
    return isVisible() ? m_steps[static_cast<std::size_t>(m_step)].target.data() : nullptr;
}

void Tour::next()
{
    if (m_step + 1 < steps())
        show(m_step + 1);
    else
        end();
}

void Tour::previous()
{
    if (m_step > 0)
        show(m_step - 1);
}

void Tour::breakOff()
{
    if (QWidget* lit = target())
        lit->removeEventFilter(this);
    hide();
}

void Tour::end()
{
    breakOff();
    emit ended();
}

void Tour::show(int step)
{
    if (QWidget* before = target())
        before->removeEventFilter(this);
    m_step = step;
    emit pageRequested(m_steps[static_cast<std::size_t>(step)].where);
    if (QWidget* now = target())
        now->installEventFilter(this);
    retranslateUi();
    raise();
    m_next->setFocus();
    kit::announce(*m_words);
}

void Tour::retranslateUi()
{
    setAccessibleName(tr("Tour"));
    m_skip->setText(tr("Skip the tour"));
    m_back->setText(tr("Back"));
    if (!m_steps.empty()) {
        const Step& now = m_steps[static_cast<std::size_t>(m_step)];
        m_title->setText(tr(now.title));
        m_words->setText(tr(now.words));
        //: Steps of a tour: "2 of 6"
        m_count->setText(tr("%1 of %2").arg(m_step + 1).arg(steps()));
    }
    const bool isLast = m_step + 1 >= steps();
    m_next->setText(isLast ? tr("Done") : tr("Next"));
    m_skip->setVisible(!isLast);
    m_back->setEnabled(m_step > 0);
    for (QPushButton* button : {m_skip, m_back, m_next})
        button->setAccessibleName(button->text());
    m_next->setAccessibleDescription(m_title->text() + QStringLiteral(". ") + m_words->text());
    place();
}

/// Places the card below, above or beside the target, where there is room. If there is no room, places it on the
/// target.
void Tour::place()
{
    QWidget* lit = target();
    if (lit == nullptr)
        return;
    m_lit = QRect(lit->mapTo(window(), QPoint()) - mapTo(window(), QPoint()), lit->size()).intersected(rect());
    m_card->layout()->activate();
    const int wide = std::min(std::max(kTourCardPx, m_card->minimumSizeHint().width()), width() - 2 * kTourGapPx);
    const int high = std::max(m_card->layout()->hasHeightForWidth() ? m_card->layout()->totalHeightForWidth(wide) : 0,
                              m_card->sizeHint().height());
    const QSize size(wide, high);
    const QRect room = rect().adjusted(kTourGapPx, kTourGapPx, -kTourGapPx, -kTourGapPx);
    const auto within = [&](QPoint corner) {
        corner.setX(std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - size.width())));
        corner.setY(std::clamp(corner.y(), room.top(), std::max(room.top(), room.bottom() - size.height())));
        return QRect(corner, size);
    };
    const QPoint middle = m_lit.center();
    const int besideX = middle.x() - size.width() / 2;
    const int besideY = middle.y() - size.height() / 2;
    const std::array places{
        within({besideX, m_lit.bottom() + kTourGapPx}), within({besideX, m_lit.top() - kTourGapPx - size.height()}),
        within({m_lit.left() - kTourGapPx - size.width(), besideY}), within({m_lit.right() + kTourGapPx, besideY})};
    const auto free =
        std::find_if(places.begin(), places.end(), [this](const QRect& one) { return !one.intersects(m_lit); });
    m_card->setGeometry(free == places.end() ? within({besideX, m_lit.bottom() - kLiftPx - size.height()}) : *free);
    update();
}

void Tour::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF lit = QRectF(m_lit).adjusted(-kAroundPx, -kAroundPx, kAroundPx, kAroundPx);
    QPainterPath dim;
    dim.addRect(rect());
    QPainterPath hole;
    hole.addRoundedRect(lit, kit::kRadius + kAroundPx, kit::kRadius + kAroundPx);
    painter.fillPath(dim.subtracted(hole), QColor(0, 0, 0, 150));
    painter.setBrush(Qt::NoBrush);
    // A white line and a line in the accent colour are visible in both themes, on light and dark parts.
    painter.setPen(QPen(QColor(255, 255, 255), 3.0));
    painter.drawPath(hole);
    painter.setPen(QPen(kit::tones(palette()).accent, 2.0));
    painter.drawPath(hole);
    // A triangle points from the card to the target.
    const QRectF card(m_card->geometry());
    const double x = std::clamp(lit.center().x(), card.left() + 20.0, card.right() - 20.0);
    const double y = std::clamp(lit.center().y(), card.top() + 20.0, card.bottom() - 20.0);
    QPolygonF nose;
    if (card.top() >= lit.bottom())
        nose << QPointF(x, lit.bottom() + 1.0) << QPointF(x - 9.0, card.top() + 1.0)
             << QPointF(x + 9.0, card.top() + 1.0);
    else if (card.bottom() <= lit.top())
        nose << QPointF(x, lit.top() - 1.0) << QPointF(x - 9.0, card.bottom() - 1.0)
             << QPointF(x + 9.0, card.bottom() - 1.0);
    else if (card.right() <= lit.left())
        nose << QPointF(lit.left() - 1.0, y) << QPointF(card.right() - 1.0, y - 9.0)
             << QPointF(card.right() - 1.0, y + 9.0);
    else if (card.left() >= lit.right())
        nose << QPointF(lit.right() + 1.0, y) << QPointF(card.left() + 1.0, y - 9.0)
             << QPointF(card.left() + 1.0, y + 9.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawPolygon(nose);
}

void Tour::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    place();
}

/// Places the card again when the target is moved or resized. Handles the arrow keys for the buttons of the card, which
/// would otherwise move the focus to the next button.
bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    const bool isButton =
        qobject_cast<QPushButton*>(watched) != nullptr && m_card->isAncestorOf(static_cast<QWidget*>(watched));
    if (isButton && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right) {
            keyPressEvent(static_cast<QKeyEvent*>(event));
            return true;
        }
    }
    const bool isMoved =
        event->type() == QEvent::Resize || event->type() == QEvent::Move || event->type() == QEvent::Show;
    if (isMoved && !isButton)
        QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

/// Blocks the shortcuts of the window, except those that end the tour, lock the window or quit the program.
bool Tour::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const QKeySequence pressed(static_cast<QKeyEvent*>(event)->keyCombination());
        for (const QAction* action : {m_actions.back, m_actions.lock, m_actions.quit})
            if (action->shortcut() == pressed)
                return QWidget::event(event);
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void Tour::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Right || event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        next();
    else if (event->key() == Qt::Key_Left)
        previous();
    event->accept();
}

/// Blocks clicks beside the card.
void Tour::mousePressEvent(QMouseEvent* event)
{
    event->accept();
}

/// Moves the focus among the buttons of the card only.
bool Tour::focusNextPrevChild(bool next)
{
    std::vector<QPushButton*> buttons;
    for (QPushButton* button : {m_skip, m_back, m_next})
        if (button->isVisible() && button->isEnabled())
            buttons.push_back(button);
    if (buttons.empty())  // the tour is hidden
        return QWidget::focusNextPrevChild(next);
    const auto now =
        std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* one) { return one->hasFocus(); });
    const auto count = static_cast<std::ptrdiff_t>(buttons.size());
    const std::ptrdiff_t place = now == buttons.end() ? 0 : now - buttons.begin() + (next ? 1 : count - 1);
    buttons[static_cast<std::size_t>(place % count)]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
}

}  // namespace ui::window
