// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/ReplayBar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/Actions.h"
#include "ui/kit/FoldingBar.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/practice/ViewMenu.h"
#include "ui/replay/TimeLine.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::replay {
namespace {

using namespace ui::kit;
using namespace ui::practice;

constexpr std::array<double, 8> kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};
constexpr std::size_t kAsMade = 3;
/// Time after a seek during which the reported position may still be the one before.
constexpr qint64 kBehindMs = 100;
constexpr double kThereS = 0.05;
constexpr int kWordsFromPx = 1400;  ///< a narrower bar has icons only

}  // namespace

ReplayBar::ReplayBar(const Actions& actions, ViewMenu& viewMenu, QWidget* parent) : QFrame(parent)
{
    setProperty("kind", "bar");
    setObjectName(QStringLiteral("replayBar"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_line = new TimeLine(this);
    column->addWidget(m_line);
    connect(m_line, &TimeLine::seekRequested, this, &ReplayBar::seek);

    auto* bar = new FoldingBar(this);
    column->addWidget(bar);
    QHBoxLayout& row = bar->row();
    row.setContentsMargins(kSpace2, 0, kSpace4, 0);
    for (QAction* action :
         {actions.replayBegin, actions.stepBack, actions.pauseReplay, actions.stepOn, actions.replayEnd})
        row.addWidget(barButton(action, false, bar));
    row.addSpacing(kSpace2);
    m_time = new TabularDigitsLabel(bar);
    m_time->setFont(typeface(kBody, QFont::Medium));
    m_time->setObjectName(QStringLiteral("replayTime"));
    row.addWidget(m_time);
    row.addSpacing(kSpace4);
    row.addWidget(barButton(actions.slower, false, bar));
    m_speedLabel = new TabularDigitsLabel(bar);
    m_speedLabel->setFont(typeface(kBody, QFont::Medium));
    m_speedLabel->setAlignment(Qt::AlignHCenter);
    m_speedLabel->setObjectName(QStringLiteral("replaySpeed"));
    m_speedLabel->setMinimumWidth(44);
    row.addWidget(m_speedLabel);
    row.addWidget(barButton(actions.faster, false, bar));
    row.addSpacing(kSpace4);
    m_words = new QLabel(bar);
    text::bindTranslation(m_words, [this] { m_words->setText(tr("You are watching a recording")); });
    m_words->setForegroundRole(QPalette::PlaceholderText);
    row.addWidget(m_words);
    row.addStretch(1);
    for (QAction* action : {actions.along, actions.expert, actions.beside}) {
        QToolButton* button = barButton(action, true, bar);
        row.addWidget(button);
        bar->mayFold(button);
    }
    QToolButton* view = viewMenu.makeButton(bar);
    row.addWidget(view);
    bar->mayFold(view);
    auto* stop = new QPushButton(bar);
    text::bindTranslation(stop, [stop] { stop->setText(tr("Stop")); });
    stop->setProperty("kind", "filled");
    text::bindTranslation(stop, [stop] {
        stop->setAccessibleName(tr("Stop the replay"));
        stop->setToolTip(tr("Stop the replay and return to your own work (Esc)"));
    });
    stop->setFocusPolicy(Qt::TabFocus);
    connect(stop, &QPushButton::clicked, this, &ReplayBar::stopRequested);
    row.addWidget(stop);
    begin(0.0);
    text::bindTranslation(this, [this] {
        showSpeed();
        showTime();
    });
}

void ReplayBar::begin(double lengthS)
{
    m_course = {};
    m_course.lengthS = lengthS;
    m_line->setCourse(m_course);
    m_line->setBeside({});
    m_sinceSeek.invalidate();
    m_speed = kAsMade;
    showSpeed();
    setPosition(0.0);
}

void ReplayBar::setCourse(const AttemptTimeline& course)
{
    m_course = course;
    m_line->setCourse(course);
}

void ReplayBar::setBeside(const AttemptTimeline& beside)
{
    m_line->setBeside(beside);
}

void ReplayBar::setPosition(double seconds)
{
    if (m_sinceSeek.isValid() && m_sinceSeek.elapsed() < kBehindMs && std::abs(seconds - m_positionS) > kThereS)
        return;
    m_positionS = seconds;
    showTime();
}

void ReplayBar::step(bool onward)
{
    seek(onward ? m_course.stepAfter(m_positionS) : m_course.stepBefore(m_positionS));
}

void ReplayBar::seek(double seconds)
{
    m_positionS = std::clamp(seconds, 0.0, m_course.lengthS);
    m_sinceSeek.start();
    showTime();
    emit seekRequested(m_positionS);
}

void ReplayBar::changeSpeed(bool faster)
{
    if (faster ? m_speed + 1 == kSpeeds.size() : m_speed == 0)
        return;
    m_speed = faster ? m_speed + 1 : m_speed - 1;
    showSpeed();
    emit speedChosen(kSpeeds.at(m_speed));
}

void ReplayBar::showTime()
{
    m_line->setPosition(m_positionS);
    // Never shows a position past the end.
    const double shownS = std::min(m_positionS, m_course.lengthS);
    //: Progress of a recording: minutes and seconds played, and of the whole
    m_time->setText(tr("%1 of %2").arg(text::duration(shownS), text::duration(m_course.lengthS)));
}

void ReplayBar::showSpeed()
{
    //: Speed of a replay: so many times as fast as it was made
    m_speedLabel->setText(tr("%1×").arg(QLocale().toString(kSpeeds.at(m_speed))));
    m_speedLabel->setAccessibleName(tr("Speed of the replay: %1").arg(m_speedLabel->text()));
}

void ReplayBar::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    m_words->setVisible(width() >= kWordsFromPx);
}

}  // namespace ui::replay
