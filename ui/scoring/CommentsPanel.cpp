// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/CommentsPanel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTextCursor>
#include <QVBoxLayout>

#include "ui/kit/Accessibility.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using namespace ui::kit;

constexpr int kWordsPx = 72;
constexpr double kFullPoints = 100.0;
/// A number that is not a valid score is shown as typed and refused. A field that limits the digits would turn 950 into
/// 95.
constexpr double kMostTyped = 999999.0;
constexpr int kSoonFull = 500;  ///< remaining characters from which the panel says that a comment is nearly full

QLabel* label(int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(parent);
    made->setTextFormat(Qt::PlainText);
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    made->setWordWrap(true);
    return made;
}

/// Returns the draft with the text of a withdrawn comment appended.
QString below(const QString& draft, const database::AttemptComment& comment)
{
    const QString words = QString::fromStdString(comment.words);
    return draft.trimmed().isEmpty() ? words : draft + QStringLiteral("\n\n") + words;
}

}  // namespace

CommentsPanel::CommentsPanel(QWidget* parent)
    : QWidget(parent), m_counts(label(kTitle, QFont::DemiBold, QPalette::WindowText, this)),
      m_machine(label(kBody, QFont::Normal, QPalette::PlaceholderText, this)), m_listSlot(new QVBoxLayout),
      m_fault(label(kBody, QFont::Normal, QPalette::WindowText, this))
{
    m_counts->setObjectName(QStringLiteral("counts"));
    m_machine->setObjectName(QStringLiteral("machine"));
    m_fault->setObjectName(QStringLiteral("fault"));
    m_fault->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace2);
    column->addWidget(m_counts);
    column->addWidget(m_machine);
    column->addLayout(m_listSlot);
    makeComposer(*column);
    makeOverride(*column);
    column->addStretch(1);
    m_asked = m_composer;
    for (QWidget* field :
         {static_cast<QWidget*>(m_words), static_cast<QWidget*>(m_points), static_cast<QWidget*>(m_reason)})
        field->installEventFilter(this);
    retell();
}

void CommentsPanel::makeComposer(QVBoxLayout& column)
{
    m_composer = new QWidget(this);
    auto* inside = new QVBoxLayout(m_composer);
    inside->setContentsMargins(0, kSpace2, 0, 0);
    inside->setSpacing(kSpace2);
    m_said = label(kBody, QFont::Normal, QPalette::WindowText, m_composer);
    m_said->setObjectName(QStringLiteral("commentSaid"));
    m_said->hide();
    inside->addWidget(m_said);
    m_words = new QPlainTextEdit(m_composer);
    m_words->setObjectName(QStringLiteral("commentWords"));
    m_words->setTabChangesFocus(true);
    m_words->setFixedHeight(kWordsPx);
    inside->addWidget(m_words);
    m_room = label(kSmall, QFont::Normal, QPalette::WindowText, m_composer);
    m_room->setObjectName(QStringLiteral("commentRoom"));
    inside->addWidget(m_room);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace4);
    m_atMoment = new QCheckBox(m_composer);
    m_atMoment->setObjectName(QStringLiteral("atMoment"));
    m_atPlace = new QCheckBox(m_composer);
    m_atPlace->setObjectName(QStringLiteral("atPlace"));
    m_add = new QPushButton(m_composer);
    m_add->setObjectName(QStringLiteral("addComment"));
    m_add->setAutoDefault(true);
    row->addWidget(m_atMoment);
    row->addWidget(m_atPlace);
    row->addStretch(1);
    row->addWidget(m_add);
    inside->addLayout(row);
    m_howToPin = label(kSmall, QFont::Normal, QPalette::PlaceholderText, m_composer);
    m_howToPin->setObjectName(QStringLiteral("howToPin"));
    inside->addWidget(m_howToPin);
    column.addWidget(m_composer);
    connect(m_words, &QPlainTextEdit::textChanged, this, &CommentsPanel::updateRoom);
    connect(m_atMoment, &QCheckBox::toggled, this, [this](bool isTicked) {
        if (!isTicked) {
            m_moment = m_seen;
            updatePins();
        }
    });
    connect(m_add, &QPushButton::clicked, this, [this] {
        m_asked = m_composer;
        m_fault->hide();
        say({});
        const QString words = m_words->toPlainText().trimmed();
        send({false, words});
        emit commentRequested(words, m_atMoment->isChecked() ? m_moment : std::nullopt,
                              m_atPlace->isChecked() ? m_place : std::nullopt);
    });
}

void CommentsPanel::makeOverride(QVBoxLayout& column)
{
    m_override = new QWidget(this);
    auto* inside = new QVBoxLayout(m_override);
    inside->setContentsMargins(0, kSpace2, 0, 0);
    inside->setSpacing(kSpace2);
    inside->addWidget(line(m_override));
    m_overrideTitle = label(kBody, QFont::DemiBold, QPalette::WindowText, m_override);
    inside->addWidget(m_overrideTitle);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace2);
    m_points = kit::numberInput(-kMostTyped, kMostTyped, 1, {}, {}, m_override);
    m_points->setObjectName(QStringLiteral("givenPoints"));
    m_points->setMinimumHeight(34);
    m_points->setMaximumWidth(QWIDGETSIZE_MAX);  // the unit is a word, so the field may be wide
    m_reason = new QLineEdit(m_override);
    m_reason->setObjectName(QStringLiteral("reason"));
    m_reason->setMaxLength(database::kLongestComment);
    row->addWidget(m_points);
    row->addWidget(m_reason, 1);
    inside->addLayout(row);
    // Keeps its space while hidden, so that the buttons do not move under the pointer.
    m_beyond = kit::faultLabel(m_override);
    m_beyond->setObjectName(QStringLiteral("pointsBeyond"));
    QSizePolicy keepsPlace = m_beyond->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    m_beyond->setSizePolicy(keepsPlace);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_beyond, 1);
    m_again = new QPushButton(m_override);
    m_again->setObjectName(QStringLiteral("machineAgain"));
    m_give = new QPushButton(m_override);
    m_give->setObjectName(QStringLiteral("giveScore"));
    for (QPushButton* button : {m_again, m_give})
        button->setAutoDefault(true);
    buttons->addWidget(m_again);
    buttons->addWidget(m_give);
    inside->addLayout(buttons);
    column.addWidget(m_override);
    connect(m_reason, &QLineEdit::textChanged, this, &CommentsPanel::updateReady);
    connect(m_points, &QDoubleSpinBox::valueChanged, this, [this](double points) {
        m_arePointsTyped = points != m_offered;
        updateReady();
    });
    updateReady();
    const auto ask = [this](std::optional<int> tenths) {
        m_asked = m_override;
        m_fault->hide();
        const QString reason = m_reason->text().trimmed();
        send({true, reason, tenths});
        emit overrideRequested(tenths, reason, m_talk.overrides.size());
    };
    connect(m_give, &QPushButton::clicked, this,
            [this, ask] { ask(static_cast<int>(std::lround(10.0 * m_points->value()))); });
    connect(m_again, &QPushButton::clicked, this, [ask] { ask(std::nullopt); });
}

void CommentsPanel::setAttempt(qint64 attempt)
{
    if (attempt == m_attempt)
        return;
    m_drafts[m_attempt] = draft();
    m_attempt = attempt;
    say({});
    take(m_drafts[m_attempt]);
}

CommentsPanel::Draft CommentsPanel::draft() const
{
    return {m_words->toPlainText(),
            m_atMoment->isChecked() ? m_moment : std::nullopt,
            m_atPlace->isChecked() ? m_place : std::nullopt,
            m_reason->text(),
            m_points->value(),
            m_arePointsTyped,
            m_fault->isVisibleTo(this) ? m_fault->text() : QString(),
            m_asked == m_override};
}

void CommentsPanel::take(const Draft& draft)
{
    m_words->setPlainText(draft.words);
    m_atMoment->setChecked(false);
    setMoment(draft.momentMs);
    m_atMoment->setChecked(draft.momentMs.has_value());
    setPlace(draft.placeMm, true);
    m_reason->setText(draft.reason);
    m_arePointsTyped = false;
    m_points->setValue(hasScore(draft) ? draft.points : m_offered);
    m_arePointsTyped = draft.hasPoints;
    updateReady();
    updateRoom();
    m_asked = draft.isScoreRefused ? m_override : m_composer;
    refuse(draft.fault);
    m_hasPlayed = false;
}

void CommentsPanel::setScore(int machineTenths, int passMarkTenths, bool passedByMachine)
{
    m_machineTenths = machineTenths;
    m_passMarkTenths = passMarkTenths;
    m_passedByMachine = passedByMachine;
    offerPoints(machineTenths);
    updateScore();
}

/// Fills in points, unless the teacher has typed a number or a reason.
void CommentsPanel::offerPoints(int tenths)
{
    m_offered = tenths / 10.0;
    if (!m_arePointsTyped && m_reason->text().trimmed().isEmpty())
        m_points->setValue(m_offered);
}

QString CommentsPanel::unsavedChanges() const
{
    auto all = m_drafts;
    all[m_attempt] = draft();
    const auto count = [&all](bool (*has)(const Draft&)) {
        return static_cast<int>(
            std::count_if(all.begin(), all.end(), [has](const auto& one) { return has(one.second); }));
    };
    QStringList sentences;
    if (const int comments = count(&CommentsPanel::hasComment); comments > 0)
        sentences << tr("%n comment(s) were typed and are not added yet.", nullptr, comments);
    if (const int scores = count(&CommentsPanel::hasScore); scores > 0)
        sentences << tr("%n score(s) were typed and are not given yet.", nullptr, scores);
    return sentences.join(u'\n');
}

void CommentsPanel::discardChanges()
{
    m_drafts.clear();
    m_sent.clear();
    m_withdrawn.clear();
    say({});
    take({});
}

bool CommentsPanel::hasComment(const Draft& draft)
{
    return !draft.words.trimmed().isEmpty();
}

bool CommentsPanel::hasScore(const Draft& draft)
{
    return draft.hasPoints || !draft.reason.trimmed().isEmpty();
}

void CommentsPanel::setTalk(const database::AttemptTalk& talk)
{
    QWidget* form = formInUse();
    const int countedTenths = given().value_or(m_machineTenths);
    m_talk = talk;
    if (const int countsTenths = given().value_or(m_machineTenths); countsTenths != countedTenths)
        offerPoints(countsTenths);
    fill();
    updateScore();
    if (form != nullptr)
        emit formUsed(form);  // the answer has moved it
}

/// Returns whether these points were sent. A request to restore the computed score has no points, and matches any.
bool CommentsPanel::isOf(const Sent& sent, double points)
{
    return !sent.tenths || *sent.tenths == std::lround(10.0 * points);
}

/// Clears a draft that was sent, unless the user has typed other text meanwhile.
void CommentsPanel::clear(Draft& draft, const Sent& sent)
{
    if (sent.isScore && draft.reason.trimmed() == sent.words && isOf(sent, draft.points)) {
        draft.reason.clear();
        draft.hasPoints = false;
    }
    if (!sent.isScore && draft.words.trimmed() == sent.words) {
        draft.words.clear();
        draft.momentMs.reset();
        draft.placeMm.reset();
    }
}

/// Clears the fields likewise, unless they contain other text.
void CommentsPanel::clearSent(const Sent& sent)
{
    if (sent.isScore && m_reason->text().trimmed() == sent.words && isOf(sent, m_points->value())) {
        m_reason->clear();
        m_arePointsTyped = false;
    }
    if (!sent.isScore && m_words->toPlainText().trimmed() == sent.words) {
        m_words->clear();
        unpin();
    }
}

/// Returns the form that contains the focus, or null.
QWidget* CommentsPanel::formInUse() const
{
    const QWidget* at = window()->focusWidget();
    return m_composer->isAncestorOf(at) ? m_composer : m_override->isAncestorOf(at) ? m_override : nullptr;
}

void CommentsPanel::setMay(bool comment, bool override)
{
    m_mayComment = comment;
    m_mayOverride = override;
    m_composer->setVisible(comment);
    m_override->setVisible(override);
    fill();
}

void CommentsPanel::setRecorded(bool isRecorded)
{
    m_isRecorded = isRecorded;
    updatePins();
    fill();
}

void CommentsPanel::setMoment(std::optional<std::int64_t> ms)
{
    m_seen = ms;
    m_hasPlayed = !isVisible();
    if (ms && m_atMoment->isChecked())
        return;
    m_moment = ms;
    if (!ms)
        m_atMoment->setChecked(false);
    updatePins();
}

void CommentsPanel::setPlace(const std::optional<std::array<double, 3>>& placeMm, bool forComment)
{
    // A place that the teacher only looked at must not replace the place of a comment that they are writing.
    if (placeMm && !forComment && m_atPlace->isChecked() && !m_words->toPlainText().trimmed().isEmpty())
        return;
    m_place = placeMm;
    m_atPlace->setChecked(placeMm && forComment);
    updatePins();
}

void CommentsPanel::unpin()
{
    m_atMoment->setChecked(false);
    m_atPlace->setChecked(false);
}

void CommentsPanel::withdraw(qint64 comment, bool earlier)
{
    const auto found = m_withdrawn.find(comment);
    if (found == m_withdrawn.end())  // a second press, or the user has logged out
        return;
    const auto [attempt, gone] = found->second;
    m_withdrawn.erase(found);
    if (attempt != m_attempt) {  // another attempt is shown by now
        Draft& draft = m_drafts[attempt];
        if (!earlier) {
            draft.words = below(draft.words, gone);
            draft.momentMs = draft.momentMs ? draft.momentMs : gone.momentMs;
            draft.placeMm = draft.placeMm ? draft.placeMm : gone.placeMm;
        }
        return;
    }
    std::erase_if(m_talk.comments, [comment](const auto& one) { return one.id == comment; });
    // The comment's button is deleted as well, and must not pass the focus on to the score.
    if (m_list->isAncestorOf(window()->focusWidget()))
        m_words->setFocus();
    fill();
    const bool isFree = m_words->toPlainText().trimmed().isEmpty();
    if (earlier)
        say([] { return tr("This comment had been taken back already."); });
    else if (isFree)
        say([] {
            return tr("Taken back. Nobody is shown it any more. Its words are here again, to be corrected or cleared.");
        });
    else
        say([] {
            return tr("Taken back. Nobody is shown it any more. Its words are here again, below what you are writing.");
        });
    if (!earlier)
        writeAgain(gone);
    emit formUsed(m_composer);  // the answer has moved it
}

/// Appends a withdrawn comment to the text that is being written. Restores its place and moment if the text has none.
void CommentsPanel::writeAgain(const database::AttemptComment& comment)
{
    m_words->setPlainText(below(m_words->toPlainText(), comment));
    m_words->moveCursor(QTextCursor::End);
    if (comment.placeMm && !m_atPlace->isChecked()) {
        emit placeRequested(*comment.placeMm);
        setPlace(comment.placeMm, true);
    }
    if (comment.momentMs && !m_atMoment->isChecked()) {
        setMoment(comment.momentMs);
        m_atMoment->setChecked(true);
    }
}

void CommentsPanel::say(std::function<QString()> sentence)
{
    m_saying = std::move(sentence);
    m_said->setText(m_saying ? m_saying() : QString());
    m_said->setVisible(static_cast<bool>(m_saying));
    if (m_saying)
        announce(*m_said);
}

void CommentsPanel::refuse(const QString& sentence)
{
    // Shows the error in the form that was used, so that both are visible together.
    m_asked->layout()->addWidget(m_fault);
    m_fault->setText(sentence);
    m_fault->setVisible(!sentence.isEmpty());
    if (sentence.isEmpty())
        return;
    announce(*m_fault);
    emit formUsed(m_asked);
}

/// Remembers what is being sent. Sets the focus to the text field, because the button is disabled and would pass the
/// focus on to the next widget, which might be the score.
void CommentsPanel::send(const Sent& sent)
{
    if (formInUse() == (sent.isScore ? m_override : m_composer))
        (sent.isScore ? static_cast<QWidget*>(m_reason) : m_words)->setFocus();
    m_sent[m_attempt] = sent;
    updateReady();
    updateRoom();
}

void CommentsPanel::keepComment(qint64 comment, qint64 attempt, const QString& fault)
{
    m_withdrawn.erase(comment);
    if (attempt != m_attempt) {
        m_drafts[attempt].fault = fault;
        return;
    }
    fill();
    m_asked = m_composer;
    refuse(fault);
}

void CommentsPanel::answer(qint64 attempt, const QString& fault)
{
    const auto found = m_sent.find(attempt);
    if (found == m_sent.end())  // the user who sent it has logged out
        return;
    const Sent sent = found->second;
    m_sent.erase(found);
    if (attempt != m_attempt) {
        Draft& draft = m_drafts[attempt];
        draft.fault = fault;
        draft.isScoreRefused = sent.isScore;
        if (fault.isEmpty())
            clear(draft, sent);
        return;
    }
    if (fault.isEmpty())
        clearSent(sent);
    updateReady();
    updateRoom();
    m_asked = sent.isScore ? m_override : m_composer;
    refuse(fault);
}

/// Enables the button if the score is valid, a reason is given, and no score is being sent.
void CommentsPanel::updateReady()
{
    const bool isScore = m_points->value() >= 0.0 && m_points->value() <= kFullPoints;
    const bool isReady = !m_reason->text().trimmed().isEmpty() && m_sent.count(m_attempt) == 0;
    kit::showFault(m_beyond, tr("A score has 0 to 100 points."));
    m_beyond->setVisible(!isScore);
    m_give->setEnabled(isReady && isScore);
    m_again->setEnabled(isReady);
}

std::optional<int> CommentsPanel::given() const
{
    return m_talk.overrides.empty() ? std::nullopt : m_talk.overrides.back().givenTenths;
}

/// Shows the score that counts, and the computed score below it if the two differ.
void CommentsPanel::updateScore()
{
    const std::optional<int> given = this->given();
    const bool passed = given ? *given >= m_passMarkTenths : m_passedByMachine;
    const QString points = text::points(given.value_or(m_machineTenths));
    m_counts->setText(passed ? tr("%1 points, passed").arg(points) : tr("%1 points, not passed").arg(points));
    m_machine->setText(
        given ? tr("Given by %1. The machine's score: %2 points.")
                    .arg(QString::fromStdString(m_talk.overrides.back().author), text::points(m_machineTenths))
              : tr("The machine's score"));
    m_again->setVisible(given.has_value());
}

/// Shows how many characters are left when there are few, or that the comment is too long.
void CommentsPanel::updateRoom()
{
    const auto length = static_cast<int>(m_words->toPlainText().trimmed().size());
    const int room = database::kLongestComment - length;
    m_room->setVisible(room < kSoonFull);
    m_room->setText(room >= 0 ? tr("Room for %Ln more character(s)", nullptr, room)
                              : tr("%Ln character(s) too many: a comment has at most %1.", nullptr, -room)
                                    .arg(QLocale().toString(database::kLongestComment)));
    m_add->setEnabled(length > 0 && room >= 0 && m_sent.count(m_attempt) == 0);
}

void CommentsPanel::updatePins()
{
    m_atMoment->setVisible(m_moment.has_value());
    m_atMoment->setText(m_moment ? tr("at %1 of the replay").arg(text::clock(*m_moment)) : QString());
    m_atMoment->setAccessibleName(tr("Pin the comment to this moment"));
    m_atPlace->setVisible(m_place.has_value());
    m_atPlace->setText(tr("at the marked place"));
    m_atPlace->setAccessibleName(tr("Pin the comment to this place"));
    m_howToPin->setVisible(m_isRecorded && (!m_moment || !m_place));
    m_howToPin->setText(!m_moment && !m_place
                            ? tr("To pin it, click a place on the tooth above, or play the attempt to "
                                 "a moment and come back.")
                        : !m_moment ? tr("To pin it to a moment, play the attempt to there and come back.")
                                    : tr("To pin it to a place, click on the tooth above."));
}

QPushButton* CommentsPanel::takeBackButton(const database::AttemptComment& comment)
{
    auto* button = new QPushButton(tr("Take back"), m_list);
    button->setObjectName(QStringLiteral("takeBack"));
    button->setProperty("kind", "aside");
    button->setAutoDefault(true);
    //: %1: when it was written
    button->setAccessibleName(tr("Take back your comment of %1").arg(text::when(comment.writtenUtc)));
    button->setEnabled(m_withdrawn.count(comment.id) == 0);
    connect(button, &QPushButton::clicked, this, [this, button, comment] {
        m_asked = m_composer;
        m_fault->hide();
        say({});
        m_withdrawn[comment.id] = {m_attempt, comment};
        if (button->hasFocus())  // otherwise it would pass the focus on to the next widget
            m_words->setFocus();
        button->setEnabled(false);
        emit withdrawRequested(comment.id);
    });
    return button;
}

/// Adds an entry with its author, time and text. Returns its layout, for further rows.
/// @param beside  button beside the author, or null
QVBoxLayout* CommentsPanel::addEntry(QVBoxLayout& column, const std::string& author, const std::string& utc,
                                     const QString& words, QPushButton* beside)
{
    auto* inside = new QVBoxLayout;
    inside->setSpacing(kSpace1);
    QLabel* who = label(kSmall, QFont::DemiBold, QPalette::PlaceholderText, m_list);
    who->setText(QStringLiteral("%1, %2").arg(QString::fromStdString(author), text::when(utc)));
    QLabel* what = label(kBody, QFont::Normal, QPalette::WindowText, m_list);
    what->setText(words);
    what->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* head = new QHBoxLayout;
    head->addWidget(who, 1);
    if (beside != nullptr)
        head->addWidget(beside, 0, Qt::AlignTop);
    inside->addLayout(head);
    inside->addWidget(what);
    column.addLayout(inside);
    return inside;
}

/// Adds buttons that show the moment and the place to which a comment is pinned.
void CommentsPanel::addPins(QVBoxLayout& inside, const database::AttemptComment& comment)
{
    auto* pins = new QHBoxLayout;
    pins->setSpacing(kSpace2);
    const auto pin = [&](const QString& words, const QString& name) {
        auto* button = new QPushButton(words, m_list);
        button->setProperty("kind", "chip");
        button->setAutoDefault(true);
        button->setAccessibleName(name);
        button->setEnabled(m_isRecorded);
        pins->addWidget(button);
        return button;
    };
    if (comment.momentMs) {
        const QString at = text::clock(*comment.momentMs);
        //: %1: minutes and seconds
        connect(pin(tr("▶ %1").arg(at), tr("Show the moment %1").arg(at)), &QPushButton::clicked, this,
                [this, ms = *comment.momentMs] {
                    m_isLooking = true;
                    emit momentRequested(static_cast<double>(ms) / 1000.0);
                });
    }
    if (comment.placeMm)
        connect(pin(tr("◎ place"), tr("Show the place")), &QPushButton::clicked, this,
                [this, place = *comment.placeMm] { emit placeRequested(place); });
    pins->addStretch(1);
    inside.addLayout(pins);
}

/// Shows comments and score overrides in the order in which they were made.
void CommentsPanel::fill()
{
    delete m_list;
    m_list = new QWidget(this);
    auto* column = new QVBoxLayout(m_list);
    column->setContentsMargins(0, kSpace2, 0, 0);
    column->setSpacing(kSpace4);
    const auto addComment = [&](const database::AttemptComment& comment) {
        QVBoxLayout* const inside =
            addEntry(*column, comment.author, comment.writtenUtc, QString::fromStdString(comment.words),
                     comment.isMine && m_mayComment ? takeBackButton(comment) : nullptr);
        if (comment.momentMs || comment.placeMm)
            addPins(*inside, comment);
    };
    const auto addOverride = [&](const database::AttemptOverride& given) {
        const QString reason = QString::fromStdString(given.reason);
        addEntry(*column, given.author, given.givenUtc,
                 given.givenTenths ? tr("gave %1 points: %2").arg(text::points(*given.givenTenths), reason)
                                   : tr("let the machine's score count again: %1").arg(reason),
                 nullptr);
    };
    auto comment = m_talk.comments.begin();
    auto given = m_talk.overrides.begin();
    while (comment != m_talk.comments.end() || given != m_talk.overrides.end())
        if (given == m_talk.overrides.end() ||
            (comment != m_talk.comments.end() && comment->writtenUtc <= given->givenUtc))
            addComment(*comment++);
        else
            addOverride(*given++);
    if (m_talk.comments.empty() && m_talk.overrides.empty()) {
        QLabel* none = label(kBody, QFont::Normal, QPalette::PlaceholderText, m_list);
        none->setObjectName(QStringLiteral("noTalk"));
        none->setText(m_mayComment ? tr("Nobody has written anything yet. Where there is a recording, a comment can be "
                                        "pinned to a moment of the replay and to a place on the tooth.")
                                   : tr("Nobody has written anything yet. What an instructor says is here."));
        column->addWidget(none);
    }
    m_listSlot->addWidget(m_list);
    m_list->setVisible(true);
}

void CommentsPanel::retell()
{
    m_words->setPlaceholderText(tr("Write a comment"));
    m_words->setAccessibleName(tr("Comment"));
    m_add->setText(tr("Add comment"));
    m_overrideTitle->setText(tr("Give another score"));
    m_points->setAccessibleName(tr("Points given"));
    //: Behind a number
    m_points->setSuffix(tr(" points"));
    m_reason->setPlaceholderText(tr("Reason, which the student reads"));
    m_reason->setAccessibleName(tr("Reason"));
    m_give->setText(tr("Give this score"));
    m_again->setText(tr("Back to the machine's score"));
    for (QPushButton* button : {m_add, m_give, m_again})
        button->setAccessibleName(button->text());
    m_said->setText(m_saying ? m_saying() : QString());
    setMay(m_mayComment, m_mayOverride);
    updateScore();
    updatePins();
    updateRoom();
    updateReady();
}

void CommentsPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retell();
}

/// Ticks "at this moment" when the teacher returns from the replay to a comment. Does not tick it if they only opened
/// the moment of another comment.
void CommentsPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    const bool isLooking = std::exchange(m_isLooking, false);
    if (std::exchange(m_hasPlayed, false) && !isLooking && m_moment && hasComment(draft()))
        m_atMoment->setChecked(true);
}

bool CommentsPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn)
        emit formUsed(watched == m_words ? m_composer : m_override);
    return QWidget::eventFilter(watched, event);
}

}  // namespace ui::scoring
