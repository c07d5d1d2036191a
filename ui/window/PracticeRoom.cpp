// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/PracticeRoom.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineF>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/inside/SectionView.h"
#include "ui/kit/Actions.h"
#include "ui/kit/FoldingBar.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/OffBur.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/practice/HistoryPanel.h"
#include "ui/practice/LessonStrip.h"
#include "ui/practice/SidePanel.h"
#include "ui/practice/ViewMenu.h"
#include "ui/replay/ReplayBar.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"

namespace ui::window {
namespace {

constexpr int kNoticeMs = 8000;
constexpr int kNoticeIconPx = 32;
constexpr int kAccountPx = 110;       ///< largest width of the user's name
constexpr double kBurMovedPx = 16.0;  ///< distance that the bur must move before overlays are placed again
constexpr int kSectionPercent = 27;
constexpr int kUsualSectionPx = 344;
constexpr int kNarrowestSectionPx = 300;
constexpr int kWidestSectionPx = 560;
constexpr int kNarrowestViewPx = 280;
constexpr int kReferenceFromPx = 1000;  ///< in a narrower room the button to save an ideal is hidden

}  // namespace

PracticeRoom::PracticeRoom(kit::Actions& actions, practice::ViewMenu& viewMenu, tooth::ToothView* view, QWidget* parent)
    : QWidget(parent), m_view(view)
{
    // This comes before the children are made, so that they take their icons and colours from this palette.
    kit::dress(*this, kit::roomPalette());
    setAutoFillBackground(true);
    view->setParent(this);
    view->installEventFilter(this);
    connect(view, &tooth::ToothView::pressedChanged, this, &PracticeRoom::keepLayout);
    connect(view, &tooth::ToothView::frameAdvanced, this, &PracticeRoom::followBur);
    m_panel = new practice::SidePanel(actions, *view, this);
    m_section = new inside::SectionView(this);
    m_section->hide();
    m_lesson = new practice::LessonStrip(this);
    m_lesson->hide();

    m_middle = new QHBoxLayout;
    m_middle->setSpacing(1);
    m_viewColumn = new QVBoxLayout;
    m_viewColumn->setSpacing(1);
    m_viewColumn->addWidget(view, 1);
    m_middle->addWidget(m_section);
    m_middle->addLayout(m_viewColumn, 1);
    m_middle->addWidget(m_panel);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(1);
    column->addWidget(makeTopBar(actions));
    column->addWidget(m_lesson);
    column->addLayout(m_middle, 1);
    m_workBar = makeBottomBar(actions, viewMenu);
    column->addWidget(m_workBar);
    m_replay = new replay::ReplayBar(actions, viewMenu, this);
    m_replay->hide();
    column->addWidget(m_replay);
    m_history = new practice::HistoryPanel(this);

    m_hint = new QLabel(this);
    text::bindTranslation(m_hint, [this] {
        m_hint->setText(tr("Move the mouse over the tooth, press the left button to drill; right-drag turns the view; "
                           "F1 for keys"));
        if (isVisible())
            placeOverlays();
    });
    m_hint->setObjectName(QStringLiteral("hint"));

    m_remark = new QLabel(this);
    m_remark->setTextFormat(Qt::PlainText);
    m_remark->setObjectName(QStringLiteral("remark"));
    m_remark->hide();
    for (QLabel* words : {m_hint, m_remark}) {
        words->setProperty("kind", "hint");
        words->setAlignment(Qt::AlignCenter);
        words->setWordWrap(true);
        words->setAttribute(Qt::WA_TransparentForMouseEvents);
    }

    makeNotice();
    for (QLabel** name : {&m_besideName, &m_ourName}) {
        *name = new QLabel(this);
        (*name)->setProperty("kind", "hint");
        (*name)->setAttribute(Qt::WA_TransparentForMouseEvents);
        (*name)->hide();
    }
    text::bindTranslation(m_ourName, [this] {
        m_ourName->setText(tr("This attempt"));
        if (m_beside != nullptr)
            placeOverlays();
    });
}

void PracticeRoom::setExercise(QWidget* card)
{
    m_viewColumn->addWidget(card);
}

void PracticeRoom::setTrial(QWidget* card)
{
    m_trial = card;
    m_middle->insertWidget(0, card);
    card->installEventFilter(this);
}

void PracticeRoom::setBeside(QWidget* view, const QString& name)
{
    if (m_beside != nullptr)
        m_beside->removeEventFilter(this);
    m_beside = view;
    if (view != nullptr) {
        m_middle->insertWidget(m_middle->indexOf(m_viewColumn) + 1, view, 1);
        view->installEventFilter(this);
        view->show();
    }
    m_besideName->setText(name);
    m_besideName->setVisible(view != nullptr);
    m_ourName->setVisible(view != nullptr);
    placeOverlays();
}

void PracticeRoom::makeNotice()
{
    m_notice = new QFrame(this);
    m_notice->setProperty("kind", "notice");
    m_notice->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* row = new QHBoxLayout(m_notice);
    row->setContentsMargins(kit::kSpace4, kit::kSpace2, kit::kSpace6, kit::kSpace2);
    row->setSpacing(kit::kSpace4);
    auto* icon = new QLabel(m_notice);
    icon->setPixmap(
        kit::linePixmap(QStringLiteral("warning"), kit::tones(palette()).harmText, kNoticeIconPx, devicePixelRatioF()));
    row->addWidget(icon, 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    m_noticeWhat = new QLabel(m_notice);
    m_noticeWhat->setFont(kit::typeface(kit::kTitle, QFont::DemiBold));
    m_noticeWhat->setObjectName(QStringLiteral("notice"));
    m_noticeToDo = new QLabel(m_notice);
    words->addWidget(m_noticeWhat);
    words->addWidget(m_noticeToDo);
    for (QLabel* label : {m_noticeWhat, m_noticeToDo})
        label->setWordWrap(true);
    row->addLayout(words, 1);
    m_noticeTimer.setSingleShot(true);
    m_noticeTimer.setInterval(kNoticeMs);
    connect(&m_noticeTimer, &QTimer::timeout, this, &PracticeRoom::hideNotice);
    m_notice->hide();
}

/// Makes the label with the name of the user, because several users may share the computer. It is hidden for a guest.
QLabel* PracticeRoom::accountName(const kit::Actions& actions, QWidget* parent)
{
    auto* name = new QLabel(parent);
    name->setObjectName(QStringLiteral("accountName"));
    name->setFont(kit::typeface(kit::kSmall));
    name->setTextFormat(Qt::PlainText);
    kit::followWords(actions.account, name, [name, &actions] {
        const QString whole = actions.isGuest() ? QString() : actions.account->text();
        name->setText(name->fontMetrics().elidedText(whole, Qt::ElideRight, kAccountPx));
        name->setToolTip(whole);
        name->setAccessibleName(whole);
        name->setVisible(!whole.isEmpty());
    });
    return name;
}

QWidget* PracticeRoom::makeTopBar(const kit::Actions& actions)
{
    m_topBar = new kit::FoldingBar(this);
    kit::FoldingBar* frame = m_topBar;
    QHBoxLayout* row = &frame->row();
    // This is no barButton(), because its text is the tooth and not the text of the action.
    m_tooth = new QToolButton(frame);
    m_tooth->setProperty("kind", "chooser");
    m_tooth->setIcon(kit::lineIcon(QStringLiteral("down"), palette()));
    m_tooth->setIconSize({16, 16});
    m_tooth->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_tooth->setLayoutDirection(Qt::RightToLeft);  // puts the arrow behind the text, as in other menu buttons
    kit::followWords(actions.chooseTooth, m_tooth, [this, action = actions.chooseTooth] {
        m_tooth->setToolTip(action->toolTip());
        m_tooth->setStatusTip(action->statusTip());
        m_tooth->setAccessibleName(action->text());
    });
    m_tooth->setFocusPolicy(Qt::TabFocus);
    m_tooth->setObjectName(QStringLiteral("toothButton"));
    m_tooth->setFont(kit::typeface(kit::kTitle, QFont::DemiBold));
    connect(m_tooth, &QToolButton::clicked, actions.chooseTooth, &QAction::trigger);
    connect(actions.chooseTooth, &QAction::enabledChanged, m_tooth, &QToolButton::setEnabled);
    m_name = new QLabel(frame);
    m_name->setForegroundRole(QPalette::PlaceholderText);
    row->addWidget(m_tooth);
    row->addWidget(m_name, 1);
    frame->mayGo(m_name);
    row->addStretch();  // fills the place of the name when that is hidden
    auto* lessons = kit::barButton(actions.lessons, true, frame);
    row->addWidget(lessons);
    frame->mayFold(lessons);
    row->addWidget(kit::barButton(actions.openScan, false, frame));
    row->addWidget(kit::barButton(actions.openRecording, false, frame));
    row->addWidget(kit::barButton(actions.saveRecording, false, frame));
    m_saveReference = kit::barButton(actions.saveReference, false, frame);
    row->addWidget(m_saveReference);
    row->addSpacing(kit::kSpace2);
    row->addWidget(kit::barButton(actions.section, false, frame));
    row->addWidget(kit::barButton(actions.radiograph, false, frame));
    row->addWidget(kit::barButton(actions.outline, false, frame));
    row->addWidget(kit::guestSign(actions, frame));
    row->addWidget(accountName(actions, frame));
    auto* account = kit::barButton(actions.account, false, frame);
    account->setObjectName(QStringLiteral("accountButton"));
    row->addWidget(account);
    row->addWidget(kit::barButton(actions.help, false, frame));
    row->addWidget(kit::barButton(actions.fullScreen, false, frame));
    row->addWidget(kit::barButton(actions.panel, false, frame));
    return frame;
}

QWidget* PracticeRoom::makeBottomBar(const kit::Actions& actions, practice::ViewMenu& viewMenu)
{
    auto* frame = new kit::FoldingBar(this);
    frame->setObjectName(QStringLiteral("workBar"));
    QHBoxLayout& row = frame->row();
    row.setContentsMargins(kit::kSpace2, 0, kit::kSpace4, 0);
    const auto add = [&](QToolButton* button) {
        row.addWidget(button);
        frame->mayFold(button);
    };
    for (QAction* action : {actions.undo, actions.redo, actions.history, actions.reload})
        add(kit::barButton(action, true, frame));
    row.addStretch(1);
    for (QAction* action : {actions.otherHand, actions.bringHome})
        add(kit::barButton(action, true, frame));
    auto* device = kit::barButton(actions.devices, false, frame);
    device->setObjectName(QStringLiteral("deviceButton"));
    row.addWidget(device);
    add(viewMenu.makeButton(frame));
    row.addStretch(1);
    row.addWidget(kit::pageButton(actions.grade, "filled", frame));
    return frame;
}

void PracticeRoom::setTooth(const QString& title, const QString& name)
{
    m_tooth->setText(title);
    m_name->setText(name);
    m_topBar->fold();
}

void PracticeRoom::setHintVisible(bool visible)
{
    m_hintWanted = visible;
    m_hint->setVisible(m_hintWanted && !m_handHasForce && !m_replay->isVisibleTo(this));
    placeOverlays();
}

void PracticeRoom::showNotice(const QString& what, const QString& whatToDo)
{
    m_noticeWhat->setText(what);
    m_noticeToDo->setText(whatToDo);
    m_noticeToDo->setVisible(!whatToDo.isEmpty());
    m_notice->setAccessibleName(what);
    m_notice->show();
    m_noticeTimer.start();
    placeOverlays();
}

bool PracticeRoom::hideNotice()
{
    const bool wasVisible = m_notice->isVisible();
    m_noticeTimer.stop();
    m_notice->hide();
    return wasVisible;
}

void PracticeRoom::showRemark(const QString& words)
{
    m_remark->setText(words);
    m_remark->setAccessibleName(words);
    m_remark->setVisible(!words.isEmpty());
    placeOverlays();
}

void PracticeRoom::setReplaying(bool replaying)
{
    m_replay->setVisible(replaying);
    m_workBar->setVisible(!replaying);
    setHintVisible(m_hintWanted);
}

void PracticeRoom::setPanelVisible(bool visible)
{
    m_panel->setVisible(visible);
}

void PracticeRoom::setSectionVisible(bool visible)
{
    m_isSectionWanted = visible;
    fitSection();
}

void PracticeRoom::keepLayout(bool kept)
{
    layout()->setEnabled(!kept);
    if (kept)
        return;
    fitSection();
    layout()->update();  // applies changes that were made during the press
}

/// Sets the width of the section to about a quarter of the room, so that it is larger on a larger screen. On a small
/// screen the section is as narrow as the tooth view needs. Hides the section while a trial leaves no room for it.
void PracticeRoom::fitSection()
{
    if (m_view->isPressed())
        return;  // keepLayout() calls this after the release
    const int wanted = std::clamp(width() * kSectionPercent / 100, kUsualSectionPx, kWidestSectionPx);
    const bool isTried = m_trial != nullptr && m_trial->isVisibleTo(this);
    const int trialPx = isTried ? m_trial->width() + 1 : 0;
    const int spare = width() - m_panel->width() - 2 - kNarrowestViewPx - trialPx;
    m_section->setFixedWidth(std::max(kNarrowestSectionPx, std::min(wanted, spare)));
    m_section->setVisible(m_isSectionWanted && (!isTried || spare >= kNarrowestSectionPx));
}

QRect PracticeRoom::viewArea() const
{
    return m_view->geometry();
}

bool PracticeRoom::eventFilter(QObject* watched, QEvent* event)
{
    if ((watched == m_view || watched == m_beside) &&
        (event->type() == QEvent::Resize || event->type() == QEvent::Move)) {
        m_areaIsNew = true;  // burAt() is correct only after the view has handled the event
        placeOverlays();
        emit viewAreaChanged();
    }
    if (watched == m_trial && (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent))
        fitSection();
    return QWidget::eventFilter(watched, event);
}

void PracticeRoom::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_saveReference->setVisible(width() >= kReferenceFromPx);  // the shortcut works even while the button is hidden
    m_topBar->fold();
    fitSection();
}

void PracticeRoom::placeOverlays()
{
    const QRect area = viewArea();
    placeAtFoot(*m_hint, area);
    placeAtFoot(*m_remark, area);
    m_history->placeIn(area);
    const auto placeName = [](QLabel* label, const QRect& over) {
        label->adjustSize();
        const int wide = std::min(label->width(), over.width() - 2 * kit::kSpace2);
        label->setGeometry(over.center().x() - wide / 2, over.top() + kit::kSpace2, wide, label->height());
        label->raise();
    };
    if (m_beside != nullptr) {
        placeName(m_ourName, area);
        placeName(m_besideName, m_beside->geometry());
    }
    placeNotice();
}

void PracticeRoom::followBur()
{
    std::optional<QPointF> bur = m_view->burAt();
    if (bur)
        *bur += m_view->pos();
    const bool isFollowed = m_view->isPressed() || m_replay->isVisibleTo(this) || !m_bur || !bur;
    if (!std::exchange(m_areaIsNew, false) && !isFollowed)
        return;
    if (m_bur.has_value() == bur.has_value() && (!bur || QLineF(*m_bur, *bur).length() < kBurMovedPx))
        return;
    m_bur = bur;
    placeOverlays();
    emit viewAreaChanged();
}

/// Places a label at the lower edge of the view, or at the upper edge if it would cover the bur. Only one such label is
/// visible at a time.
void PracticeRoom::placeAtFoot(QLabel& words, const QRect& area) const
{
    const QSize oneLine = words.fontMetrics().size(0, words.text());
    const int width = std::min(area.width() - 2 * kit::kSpace4, oneLine.width() + 2 * kit::kSpace6);
    const int height = words.heightForWidth(width);
    const QRect atFoot(area.center().x() - width / 2, area.bottom() - kit::kSpace4 - height, width, height);
    const QRect atTop(atFoot.left(), area.top() + kit::kBelowMessagePx, width, height);
    words.setGeometry(kit::placeOffBur(m_bur, atFoot, atTop).toRect());
    words.raise();
}

/// Places the notice, as wide as its text if there is room, and away from the bur.
void PracticeRoom::placeNotice()
{
    const QRect area = viewArea();
    int words = 0;
    for (const QLabel* label : {m_noticeWhat, m_noticeToDo})
        words = std::max(words, label->fontMetrics().horizontalAdvance(label->text()));
    const int around = kit::kSpace4 + kNoticeIconPx + kit::kSpace4 + kit::kSpace6 + 2 * kit::kSpace1;
    const int width = std::min(area.width() - 2 * kit::kSpace2, words + around);
    m_notice->resize(width, m_notice->layout()->totalHeightForWidth(width));
    const QRect atTop(QPoint(area.center().x() - width / 2, area.top() + kit::kBelowMessagePx), m_notice->size());
    const int foot = m_remark->isVisibleTo(this) ? m_remark->y() : area.bottom();
    const QRect atFoot(QPoint(atTop.left(), foot - kit::kSpace4 - atTop.height()), atTop.size());
    m_notice->move(kit::placeOffBur(m_bur, atTop, atFoot).topLeft().toPoint());
    m_notice->raise();
}

}  // namespace ui::window
