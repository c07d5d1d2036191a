// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
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

#include "app/school/SchoolAccess.h"
#include "core/base/Result.h"
#include "core/recording/Recording.h"
#include "database/Outbox.h"
#include "database/sql/Database.h"
#include "database/sql/DatabaseContext.h"

namespace app {

/// An entry of the outbox that was read.
struct LetterDelivery
{
    std::string attempt;  ///< uid of the attempt; empty: the entry says that an exam has begun
    QString school;       ///< the school it is for, as Outbox::schoolAt() names it; empty: unknown
    std::function<core::Status(const database::sql::DatabaseContext&)> deliver;
};
[[nodiscard]] core::Result<LetterDelivery> readLetter(const database::Outbox& letters, const QString& file);

/// The connection to a school's database, on a thread of its own: the window does not wait for a slow server, a
/// sleeping disk or the hashing of a password. Requests are done in their order, and results come back on the ui
/// thread.
class SchoolService final : public QObject, public SchoolAccess
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kRetry{10};

    /// @param address  of the database; open() opens it
    /// @param folder  for this station's own files: its key and its outbox
    /// @param options  for tests
    /// @param retry  the time after which a failed request is repeated
    SchoolService(database::Address address, QString folder, database::sql::Database::Options options = {},
                  std::chrono::milliseconds retry = kRetry);
    ~SchoolService() override;

    /// The result of opening the database.
    struct Opening
    {
        core::Status status;
        bool isNew = false;     ///< the school has no people yet
        std::string notice;     ///< a remark of the database for the user
        QString soundBackup;    ///< the newest backup that can replace a damaged or missing file; empty: there is none
        core::Status restored;  ///< whether restore() replaced the file; `status` says whether the database is open now
        QString replaced;       ///< after restore(): the new place of the old file; empty: there was none
    };
    using Opened = std::function<void(const Opening&)>;
    /// May be called again after a failure.
    void open(QObject* owner, const Opened& done);
    /// Replaces the file by a backup and opens it. Attempts of this station that were delivered after the backup was
    /// made are delivered again. While a school is open, admins only.
    void restore(QObject* owner, const database::Login& session, const QString& backup, const Opened& done);

    void expectAlone(QObject* owner, const database::Login& session,
                     const std::function<void(const core::Status&)>& done) override;

    /// As ask() and askBeside(), for work on the database itself, such as a backup.
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

    /// Writes a graded attempt to the outbox and passes to `kept` whether it is on the disk. delivered() is emitted
    /// when the database has it, perhaps much later.
    void keep(QObject* owner, const database::Login& session, const database::AttemptRecord& attempt,
              const core::recording::Recording& recording, const std::function<void(const core::Status&)>& kept);

    /// The same for an exam that has begun.
    void keep(QObject* owner, const database::Login& session, const database::ExamStart& start,
              const std::function<void(const core::Status&)>& kept);

    void countWaiting(QObject* owner, const database::Login& session, const std::function<void(int)>& done) override;

    [[nodiscard]] int retryMs() const override { return m_retry.interval(); }

    /// Tries to deliver the outbox.
    void deliver();

    /// After otherSchool(), when nobody is logged in any more: allows to open the school that is there now.
    void takeOtherSchool();

signals:
    /// Emitted when the database has this attempt.
    void delivered(const QString& uid);
    /// Emitted when an attempt in the outbox is damaged; its file is kept.
    void damaged(const core::Error& error);
    /// Emitted when the account of the user who asked has been disabled since the login.
    void disabled();
    /// Emitted when a request was not allowed: the role of the user may have changed since the login.
    void refused();
    /// Emitted when the file of another school has replaced the file of this one; it is not opened.
    void otherSchool();
    /// Emitted when so many attempts cannot be delivered to this school or with this station's key. They wait.
    void waitOn(int count);
    /// Emitted when so many attempts in the outbox are for other schools. They wait.
    /// @param schools  as Outbox::schoolAt() names them
    void waitForOthers(int count, const QString& schools);
    /// Emitted when a request has had no answer for 5 seconds: the server hangs, or another program holds the file.
    void unanswered();
    /// Emitted when a request was answered without an error.
    void answered();
    /// Emitted when the school can be reached again after a request could not be answered.
    void isBack();

private:
    using DatabaseJob = JobOn<database::sql::DatabaseContext>;
    void run(Job job) override;
    void runBeside(Job job) override;
    /// On the school's thread, in the order of the calls.
    void runOnDatabase(DatabaseJob job);
    /// On a connection and a thread of its own, if the file allows a second connection (not on a network drive).
    void runOnDatabaseBeside(DatabaseJob job);
    [[nodiscard]] static DatabaseJob overRepositories(Job job);
    /// On the ui thread.
    void takeAnswer(const std::optional<core::ErrorCode>& fault);
    void tryAgain();
    /// Any thread.
    [[nodiscard]] static core::Result<database::StationKey> keyOf(const QString& folder);
    void post(std::function<void()> job);
    /// Gives a result to `done` on the ui thread, unless `owner` has gone meanwhile.
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
    // The following functions run on the school's thread.
    [[nodiscard]] core::Status connect();
    [[nodiscard]] core::Status openDatabase();
    [[nodiscard]] core::Status expectSameSchool(const QSqlDatabase& db);
    [[nodiscard]] core::Status mayRestore(const database::Login& session);
    [[nodiscard]] Opening tryToOpen();
    [[nodiscard]] QString outboxFolder() const;
    [[nodiscard]] database::Outbox outbox() const;
    void notice(const core::Error& error);
    [[nodiscard]] core::Status putInto(const std::function<core::Status(database::Outbox)>& put);
    void deliverAll();
    [[nodiscard]] bool isForAnother(const LetterDelivery& letter) const;
    void setAside(const database::Outbox& outbox, const QString& file, const core::Error& why);

    database::Address m_address;
    QString m_folder;
    database::sql::Database::Options m_options;
    /// The number of long requests that are running.
    std::shared_ptr<std::atomic<int>> m_besides = std::make_shared<std::atomic<int>>(0);
    std::atomic<bool> m_allowsOthers = true;  ///< the file allows a second connection
    QThread m_thread;
    QObject m_there;  ///< lives on m_thread
    QTimer m_retry;

    std::unique_ptr<database::sql::Database> m_database;
    std::unique_ptr<database::sql::DatabaseContext> m_school;
    std::string m_known;  ///< the school, as schoolOf() identifies it; empty: none yet
    std::optional<database::StationKey> m_key;
    QSet<QString> m_forOthers;  ///< entries of the outbox for other schools
    QSet<QString> m_otherSchools;
    QTimer m_patience{this};
    int m_asked = 0;                  ///< pending requests
    bool m_wasAway = false;           ///< at the last request
    QSet<QString> m_undeliverable;    ///< entries that cannot be delivered on this connection
    QHash<QString, int> m_hasFailed;  ///< entries that may be delivered later, with the number of their last failure
    int m_failures = 0;
    bool m_isLost = false;
    bool m_isDamaged = false;   ///< the file, when it was opened last
    bool m_isReadOnly = false;  ///< the same
};

}  // namespace app
