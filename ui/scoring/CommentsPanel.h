// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include <QString>
#include <QWidget>

#include "database/ClassOverview.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace ui::scoring {

/// What people say of an attempt: comments, each perhaps pinned to a moment and to a place on the tooth, and the score
/// that an instructor gave instead of the machine's, with the reason. Everything is signed. The machine's score stays
/// in sight. Who may not write reads.
class CommentsPanel final : public QWidget
{
    Q_OBJECT
public:
    explicit CommentsPanel(QWidget* parent);

    /// Shows the talk about this attempt, 0: none that is saved. What the user has typed about the attempt before stays
    /// in memory until that is shown again.
    void setAttempt(qint64 attempt);
    [[nodiscard]] qint64 attempt() const { return m_attempt; }
    /// Describes the comments and scores that the user has typed and not sent, about any attempt. Empty: there are
    /// none.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges();
    /// @param machineTenths  what the machine gave
    void setScore(int machineTenths, int passMarkTenths, bool passedByMachine);
    void setTalk(const database::AttemptTalk& talk);
    void setMay(bool comment, bool override);
    /// Without a recording there is neither a moment nor a place to be seen, or to be pinned to.
    void setRecorded(bool isRecorded);
    /// Where the replay was seen last; nothing: it has not been. A moment that is ticked stays what was ticked; whoever
    /// comes back from there to what he is writing finds it ticked.
    void setMoment(std::optional<std::int64_t> ms);
    /// The place that is marked on the tooth, in its frame, mm.
    /// @param forComment  it was marked by who writes, so that what he writes is about it
    void setPlace(const std::optional<std::array<double, 3>>& placeMm, bool forComment = false);
    [[nodiscard]] const std::optional<std::array<double, 3>>& place() const { return m_place; }
    /// Removes one's own comment. Its words and pins return to the field, or to what was typed about its attempt if
    /// another attempt is shown by now.
    /// @param earlier  somebody had done it already, and may have written it anew
    void withdraw(qint64 comment, bool earlier);
    /// Says why what was written could not be kept. It stays where it was typed.
    void refuse(const QString& sentence);
    /// It could not be taken back, and why, told at its attempt, now or when that is shown again.
    void keepComment(qint64 comment, qint64 attempt, const QString& fault);
    /// What was wanted of this attempt has been done, and what was sent leaves its field; or not. Until then nothing
    /// more is sent of it.
    /// @param fault  why it was not done, told at the attempt, now or when it is shown again; empty: it was
    void answer(qint64 attempt, const QString& fault = {});

signals:
    void commentRequested(const QString& words, std::optional<std::int64_t> momentMs,
                          std::optional<std::array<double, 3>> placeMm);
    /// One's own, to be taken back.
    void withdrawRequested(qint64 comment);
    /// @param tenths  nothing: the machine's score counts again
    /// @param before  so many were given so far, as it is shown here
    void overrideRequested(std::optional<int> tenths, const QString& reason, std::size_t before);
    /// A pinned comment is to be seen where it belongs.
    void momentRequested(double seconds);
    void placeRequested(std::array<double, 3> placeMm);
    /// Somebody writes in this part of the panel, which is to be in sight as a whole.
    void formUsed(QWidget* form);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// What the user has typed about an attempt and not sent.
    struct Draft
    {
        QString words;
        std::optional<std::int64_t> momentMs;
        std::optional<std::array<double, 3>> placeMm;
        QString reason;
        double points = 0.0;
        bool hasPoints = false;  ///< that somebody has typed
        QString fault = {};      ///< why it could not be kept
        bool isScoreRefused = false;
    };

    /// What somebody has asked to be kept.
    struct Sent
    {
        bool isScore = false;
        QString words;                ///< of the comment, or the reason
        std::optional<int> tenths{};  ///< of a score
    };

    [[nodiscard]] Draft draft() const;
    void take(const Draft& draft);
    [[nodiscard]] static bool hasComment(const Draft& draft);
    [[nodiscard]] static bool hasScore(const Draft& draft);
    static void clear(Draft& draft, const Sent& sent);
    void clearSent(const Sent& sent);
    [[nodiscard]] static bool isOf(const Sent& sent, double points);
    void makeComposer(QVBoxLayout& column);
    void makeOverride(QVBoxLayout& column);
    void retell();
    void fill();
    QVBoxLayout* addEntry(QVBoxLayout& column, const std::string& author, const std::string& utc, const QString& words,
                          QPushButton* beside);
    void addPins(QVBoxLayout& inside, const database::AttemptComment& comment);
    /// What an instructor has given; nothing: the machine's score counts.
    [[nodiscard]] std::optional<int> given() const;
    void tellScore();
    void tellPins();
    void tellRoom();
    void unpin();
    void offerPoints(int tenths);
    void tellReady();
    void send(const Sent& sent);
    void writeAgain(const database::AttemptComment& comment);
    void say(std::function<QString()> sentence);
    [[nodiscard]] QPushButton* takeBackButton(const database::AttemptComment& comment);
    [[nodiscard]] QWidget* formInUse() const;

    /// A comment that is to be taken back.
    struct Withdrawn
    {
        qint64 attempt = 0;
        database::AttemptComment comment;
    };

    std::map<qint64, Draft> m_drafts;         ///< about the other attempts
    std::map<qint64, Sent> m_sent;            ///< by attempt, until it is answered
    std::map<qint64, Withdrawn> m_withdrawn;  ///< by comment, until that is done
    qint64 m_attempt = 0;
    database::AttemptTalk m_talk;
    int m_machineTenths = 0;
    int m_passMarkTenths = 0;
    bool m_passedByMachine = false;
    double m_offered = 0.0;  ///< points, to begin with
    bool m_arePointsTyped = false;
    bool m_mayComment = false;
    bool m_mayOverride = false;
    bool m_isRecorded = true;
    std::optional<std::int64_t> m_seen;    ///< where the replay was last
    std::optional<std::int64_t> m_moment;  ///< that can be ticked, or is
    bool m_hasPlayed = false;              ///< since the panel was seen last
    bool m_isLooking = false;              ///< at what a comment is pinned to
    std::optional<std::array<double, 3>> m_place;
    QLabel* m_counts;
    QLabel* m_machine;
    QWidget* m_list = nullptr;
    QVBoxLayout* m_listSlot;
    QWidget* m_composer = nullptr;
    QLabel* m_said = nullptr;  ///< of a comment that was taken back
    std::function<QString()> m_saying;
    QPlainTextEdit* m_words = nullptr;
    QCheckBox* m_atMoment = nullptr;
    QCheckBox* m_atPlace = nullptr;
    QLabel* m_room = nullptr;  ///< for so many more characters
    QPushButton* m_add = nullptr;
    QLabel* m_howToPin = nullptr;
    QWidget* m_override = nullptr;
    QLabel* m_overrideTitle = nullptr;
    QDoubleSpinBox* m_points = nullptr;
    QLabel* m_beyond = nullptr;  ///< that the points are no score
    QLineEdit* m_reason = nullptr;
    QPushButton* m_give = nullptr;
    QPushButton* m_again = nullptr;
    QWidget* m_asked = nullptr;  ///< the form that something was wanted by last
    QLabel* m_fault;             ///< in that
};

}  // namespace ui::scoring
