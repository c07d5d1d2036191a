// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include <QHash>
#include <QObject>
#include <QPointer>
#include <QSet>
#include <QString>
#include <QThread>
#include <QTimer>

#include "app/school/AuditMemory.h"
#include "app/school/SchoolAccess.h"
#include "core/base/Result.h"
#include "core/recording/Recording.h"
#include "database/Doubt.h"
#include "database/Outbox.h"
#include "database/sql/Database.h"
#include "database/sql/DatabaseContext.h"

namespace app {

/// An entry of the outbox, ready to be written to the database.
struct LetterDelivery
{
    std::string attempt;  ///< uid of the attempt; empty: the entry is the start of an exam
    QString school;       ///< the school that it belongs to, as Outbox::schoolAt() identifies it; empty: unknown
    std::string digest;   ///< of all that is delivered; empty for the start of an exam
    /// Marks the attempt again, as database::checkAttempt(); any thread. Doubt::None for the start of an exam.
    std::function<database::Doubt()> check;
    /// @param doubt  the result of check()
    std::function<core::Status(const database::sql::DatabaseContext&, database::Doubt doubt)> deliver;
};
/// Reads an entry of the outbox. Errors: see Outbox::read().
[[nodiscard]] core::Result<LetterDelivery> readLetter(const database::Outbox& letters, const QString& file);

/// Holds the connection to the database of a school, on a thread of its own, so that the window does not wait for a
/// slow server, a sleeping disk or the hashing of a password. Runs requests in the order of the calls and passes their
/// results back on the ui thread.
class SchoolService final : public QObject, public SchoolAccess
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kRetry{10};

    /// @param address  address of the database, which open() opens
    /// @param folder  folder with this computer's own files: its key and its outbox
    /// @param options  changed only by tests
    /// @param retry  the time after which a failed request is repeated
    SchoolService(database::Address address, QString folder, database::sql::Database::Options options = {},
                  std::chrono::milliseconds retry = kRetry);
    ~SchoolService() override;

    /// The result of opening the database.
    struct Opening
    {
        core::Status status;
        bool isNew = false;     ///< the school has no users yet
        std::string notice;     ///< a remark for the administrator, see Database::notice(); empty: none
        QString soundBackup;    ///< newest verified backup that can replace a damaged or new file; empty: none
        core::Status restored;  ///< whether restore() replaced the file; `status` says whether the database is open now
        QString replaced;       ///< after restore(): the new path of the old file; empty: there was no file
    };
    using Opened = std::function<void(const Opening&)>;
    /// Opens the database and passes the result to `done`. May be called again after a failure.
    void open(QObject* owner, const Opened& done);
    /// Replaces the database file by a backup and opens it. Delivers the attempts of this computer again that the
    /// backup may not contain. NotAllowed: the school has users, and this user is no admin.
    void restore(QObject* owner, const database::Login& session, const QString& backup, const Opened& done);

    void expectAlone(QObject* owner, const database::Login& session,
                     const std::function<void(const core::Status&)>& done) override;

    /// Do the same as ask() and askBeside(), for work on the database itself, such as a backup.
    /// @param work  takes `const database::sql::DatabaseContext&` and returns a core::Result or core::Status
    template <class Work, class Done>
    void askDatabase(QObject* owner, Work work, Done done)
    {
        runOnDatabase(jobOf<database::sql::DatabaseContext>(owner, std::move(work), std::move(done)));
    }
    template <class Work, class Done>
    void askDatabaseBeside(QObject* owner, Work work, Done done)
    {
        runOnDatabaseBeside(jobOf<database::sql::DatabaseContext>(owner, std::move(work), std::move(done)));
    }

    /// Writes a graded attempt to the outbox, and then passes success or the error to `kept`. Emits delivered() when
    /// the attempt is in the database, which may be much later.
    void keep(QObject* owner, const database::Login& session, const database::AttemptRecord& attempt,
              const core::recording::Recording& recording, const std::function<void(const core::Status&)>& kept);

    /// Writes the start of an exam to the outbox, and then passes success or the error to `kept`.
    void keep(QObject* owner, const database::Login& session, const database::ExamStart& start,
              const std::function<void(const core::Status&)>& kept);

    void countWaiting(QObject* owner, const database::Login& session, const std::function<void(int)>& done) override;

    [[nodiscard]] int retryMs() const override { return m_retry.interval(); }

    /// Tries to write all entries of the outbox to the database.
    void deliver();

    /// Allows open() to open the school that has replaced this one. Call it after otherSchool(), when the user has been
    /// logged out.
    void takeOtherSchool();

signals:
    /// Emitted when an attempt has been written to the database.
    void delivered(const QString& uid);
    /// Emitted when an entry of the outbox is damaged. Its file is moved to the folder "damaged".
    void damaged(const core::Error& error);
    /// Emitted when a request failed because the account of the user has been disabled since the login.
    void disabled();
    /// Emitted when a request was not allowed: the role of the user may have changed since the login.
    void refused();
    /// Emitted when an older copy has taken the place of the database, as far as this account knows.
    void foundOlder();
    /// Emitted when the database of another school has replaced the database of this one. The new one is not opened.
    void otherSchool();
    /// Emitted when more entries of the outbox than before cannot be delivered: the database does not know their user,
    /// or they are signed with the key of another computer. They stay in the outbox.
    /// @param count  the number of all such entries
    void waitOn(int count);
    /// Emitted when the outbox contains more entries of other schools than before. They stay in the outbox.
    /// @param count    the number of all such entries
    /// @param schools  the other schools as Outbox::schoolAt() identifies them, separated by commas
    void waitForOthers(int count, const QString& schools);
    /// Emitted when a request has had no answer for 5 seconds: the server hangs, or another program locks the file.
    void unanswered();
    /// Emitted when a request has succeeded.
    void answered();
    /// Emitted when the database can be reached again after a request failed because it could not be reached.
    void isBack();

private:
    using DatabaseJob = JobOn<database::sql::DatabaseContext>;
    void run(Job job) override;
    void runBeside(Job job) override;
    /// Runs a request on the thread of the database, in the order of the calls.
    void runOnDatabase(DatabaseJob job);
    /// Runs a request on another connection and another thread. If the file allows no second connection, because it is
    /// on a network drive, does the same as runOnDatabase().
    void runOnDatabaseBeside(DatabaseJob job);
    /// Converts a request for the repositories to a request for the database.
    [[nodiscard]] static DatabaseJob overRepositories(Job job);
    /// Restarts or stops the timer of unanswered() and emits answered() on success. Ui thread.
    void takeAnswer(const std::optional<core::ErrorCode>& fault);
    void tryAgain();
    /// Returns the key of this computer, and creates it if there is none. Any thread.
    [[nodiscard]] static core::Result<database::StationKey> keyOf(const QString& folder);
    void post(std::function<void()> job);
    /// Passes a result to `done` on the ui thread. If `owner` is deleted before that, `done` is not called.
    template <class Done, class Value>
    void answer(const QPointer<QObject>& owner, const Done& done, const Value& value)
    {
        QMetaObject::invokeMethod(
            this,
            [owner, done, value] {
                if (owner)
                    done(value);
            },
            Qt::QueuedConnection);
    }
    // The following functions run on the thread of the database.
    [[nodiscard]] core::Status connect();
    [[nodiscard]] core::Status openDatabase();
    [[nodiscard]] core::Status expectSameSchool(const QSqlDatabase& db);
    [[nodiscard]] std::string memoryKey() const;
    void compareAudit();
    void rememberAudit();
    [[nodiscard]] core::Status mayRestore(const database::Login& session);
    [[nodiscard]] Opening tryToOpen();
    [[nodiscard]] QString outboxFolder() const;
    [[nodiscard]] database::Outbox outbox() const;
    void notice(const core::Error& error);
    [[nodiscard]] core::Status putInto(const std::function<core::Status(database::Outbox)>& put);
    void deliverAll();
    [[nodiscard]] std::optional<database::Doubt> doubtOf(const LetterDelivery& letter);
    [[nodiscard]] bool isForAnother(const LetterDelivery& letter) const;
    void setAside(const database::Outbox& outbox, const QString& file, const core::Error& why);

    database::Address m_address;
    QString m_folder;
    database::sql::Database::Options m_options;
    /// The number of requests that run on connections of their own.
    std::shared_ptr<std::atomic<int>> m_besides = std::make_shared<std::atomic<int>>(0);
    std::atomic<bool> m_allowsOthers = true;  ///< the file allows a second connection
    QThread m_thread;
    QObject m_there;  ///< lives on m_thread, so that post() can run functions there
    QTimer m_retry;

    std::unique_ptr<database::sql::Database> m_database;
    std::unique_ptr<database::sql::DatabaseContext> m_school;
    std::string m_known;  ///< id of the school that was opened first, see schoolOf(); empty: none yet
    std::optional<database::StationKey> m_key;
    AuditMemory m_memory;
    database::AuditHead m_seen;  ///< the newest row of the audit that m_memory has
    QSet<QString> m_forOthers;   ///< entries of the outbox for other schools
    QSet<QString> m_otherSchools;
    QTimer m_patience{this};
    int m_asked = 0;                  ///< pending requests
    bool m_wasAway = false;           ///< the database could not be reached at the last request
    QSet<QString> m_undeliverable;    ///< entries that cannot be delivered on this connection
    QHash<QString, int> m_hasFailed;  ///< entries that may be delivered later, with the number of their last failure
    int m_failures = 0;
    /// Attempts of the outbox by digest: those graded by this program, and those that were marked again. Somebody may
    /// have changed the files of others since they were graded.
    std::map<std::string, database::Doubt> m_checked;
    QSet<QString> m_graded;     ///< uids of the attempts that this program has graded
    bool m_isChecking = false;  ///< an attempt of an earlier run is being checked in the background
    bool m_isLost = false;      ///< the connection broke and must be made again
    bool m_isDamaged = false;   ///< the file was damaged when it was opened last
    bool m_isReadOnly = false;  ///< the file was read-only when it was opened last
};

}  // namespace app
