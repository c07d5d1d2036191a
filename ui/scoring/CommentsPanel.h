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

/// Shows the comments on an attempt and the score that a teacher gave instead of the computed one, with the reason. A
/// comment may be pinned to a moment and to a place on the tooth. All entries have an author. The computed score stays
/// visible. For users who may not write, the panel has no forms.
class CommentsPanel final : public QWidget
{
    Q_OBJECT
public:
    explicit CommentsPanel(QWidget* parent);

    /// Sets the attempt. 0: no saved attempt. Unsent text about the previous attempt is remembered and restored when
    /// that attempt is shown again.
    void setAttempt(qint64 attempt);
    [[nodiscard]] qint64 attempt() const { return m_attempt; }
    /// Returns a description of the comments and scores that the user has typed and not sent, about any attempt. Empty
    /// if there are none.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges();
    /// @param machineTenths  the computed score
    void setScore(int machineTenths, int passMarkTenths, bool passedByMachine);
    void setTalk(const database::AttemptTalk& talk);
    void setMay(bool comment, bool override);
    /// Sets whether there is a recording. Without one, comments cannot be pinned, and pins cannot be opened.
    void setRecorded(bool isRecorded);
    /// Sets the moment seen last in the replay. Empty: none. A moment that the user has ticked is not replaced.
    void setMoment(std::optional<std::int64_t> ms);
    /// Sets the place marked on the tooth, in the tooth frame, mm.
    /// @param forComment  the user marked it for the comment that they are writing, so it is ticked
    void setPlace(const std::optional<std::array<double, 3>>& placeMm, bool forComment = false);
    [[nodiscard]] const std::optional<std::array<double, 3>>& place() const { return m_place; }
    /// Removes the user's own comment after the database has withdrawn it. Its text and pins return to the form, or to
    /// the draft of its attempt if another attempt is shown by now.
    /// @param earlier  the comment had already been withdrawn elsewhere, so its text does not return
    void withdraw(qint64 comment, bool earlier);
    /// Shows why the last request failed, in the form it was made in. The text stays in the form.
    void refuse(const QString& sentence);
    /// Shows a comment again whose withdrawal failed.
    /// @param fault  the reason; shown when its attempt is shown
    void keepComment(qint64 comment, qint64 attempt, const QString& fault);
    /// Finishes the request that was sent about an attempt. If it succeeded, clears the form that it came from. Until
    /// then no other request about the attempt can be sent.
    /// @param fault  the reason of a failure, shown when the attempt is shown; empty: success
    void answer(qint64 attempt, const QString& fault = {});

signals:
    /// Emitted when the user adds a comment.
    void commentRequested(const QString& words, std::optional<std::int64_t> momentMs,
                          std::optional<std::array<double, 3>> placeMm);
    /// Emitted when the user withdraws one of their comments.
    void withdrawRequested(qint64 comment);
    /// Emitted when a teacher overrides the score.
    /// @param tenths  the new score; empty: the computed score counts again
    /// @param before  number of earlier overrides shown here
    void overrideRequested(std::optional<int> tenths, const QString& reason, std::size_t before);
    /// Emitted when the user opens the moment or the place that a comment is pinned to.
    void momentRequested(double seconds);
    void placeRequested(std::array<double, 3> placeMm);
    /// Emitted when the user writes in a form of the panel. The page then scrolls the whole form into view.
    void formUsed(QWidget* form);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Text that the user has typed about an attempt and not sent.
    struct Draft
    {
        QString words;
        std::optional<std::int64_t> momentMs;
        std::optional<std::array<double, 3>> placeMm;
        QString reason;
        double points = 0.0;
        bool hasPoints = false;  ///< the user has typed a score
        QString fault = {};      ///< why it could not be saved
        bool isScoreRefused = false;
    };

    /// A request that was sent to the database.
    struct Sent
    {
        bool isScore = false;
        QString words;                ///< the comment, or the reason for the score
        std::optional<int> tenths{};  ///< of the score
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
    /// Returns the score that a teacher has given. Empty if the computed score counts.
    [[nodiscard]] std::optional<int> given() const;
    void updateScore();
    void updatePins();
    void updateRoom();
    void unpin();
    void offerPoints(int tenths);
    void updateReady();
    void send(const Sent& sent);
    void writeAgain(const database::AttemptComment& comment);
    void say(std::function<QString()> sentence);
    [[nodiscard]] QPushButton* takeBackButton(const database::AttemptComment& comment);
    [[nodiscard]] QWidget* formInUse() const;

    /// A comment whose withdrawal was requested.
    struct Withdrawn
    {
        qint64 attempt = 0;
        database::AttemptComment comment;
    };

    std::map<qint64, Draft> m_drafts;         ///< about the other attempts, by attempt
    std::map<qint64, Sent> m_sent;            ///< by attempt, until answered
    std::map<qint64, Withdrawn> m_withdrawn;  ///< by comment, until answered
    qint64 m_attempt = 0;
    database::AttemptTalk m_talk;
    int m_machineTenths = 0;
    int m_passMarkTenths = 0;
    bool m_passedByMachine = false;
    double m_offered = 0.0;  ///< initial value of the points input, in points
    bool m_arePointsTyped = false;
    bool m_mayComment = false;
    bool m_mayOverride = false;
    bool m_isRecorded = true;
    std::optional<std::int64_t> m_seen;    ///< the last moment seen in the replay
    std::optional<std::int64_t> m_moment;  ///< the moment that can be ticked or is ticked
    bool m_hasPlayed = false;              ///< the replay has played since the panel was last visible
    bool m_isLooking = false;              ///< the user has opened a comment's pin
    std::optional<std::array<double, 3>> m_place;
    QLabel* m_counts;
    QLabel* m_machine;
    QWidget* m_list = nullptr;
    QVBoxLayout* m_listSlot;
    QWidget* m_composer = nullptr;
    QLabel* m_said = nullptr;  ///< the message after a comment was withdrawn
    std::function<QString()> m_saying;
    QPlainTextEdit* m_words = nullptr;
    QCheckBox* m_atMoment = nullptr;
    QCheckBox* m_atPlace = nullptr;
    QLabel* m_room = nullptr;  ///< the number of characters left
    QPushButton* m_add = nullptr;
    QLabel* m_howToPin = nullptr;
    QWidget* m_override = nullptr;
    QLabel* m_overrideTitle = nullptr;
    QDoubleSpinBox* m_points = nullptr;
    QLabel* m_beyond = nullptr;  ///< the error of points outside 0 to 100
    QLineEdit* m_reason = nullptr;
    QPushButton* m_give = nullptr;
    QPushButton* m_again = nullptr;
    QWidget* m_asked = nullptr;  ///< the form of the last request
    QLabel* m_fault;             ///< the error in that form
};

}  // namespace ui::scoring
