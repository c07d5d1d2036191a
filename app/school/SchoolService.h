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

/// A letter of the outbox that was read.
struct LetterDelivery
{
    std::string attempt;  ///< its uid; empty: an exam's beginning
    QString school;       ///< for which it was put there; empty: unknown
    std::function<core::Status(const database::sql::DatabaseContext&)> deliver;
};
[[nodiscard]] core::Result<LetterDelivery> readLetter(const database::Outbox& letters, const QString& file);

/// Work that is done on the functions of database::sql.
template <class Work>
concept DatabaseWork = std::is_invocable_v<Work&, const database::sql::DatabaseContext&>;

/// The school's data, on a thread of its own: a server that is slow or away, a disk that sleeps and the hashing of a
/// password hold up no window. What is asked is done in the order of asking; answers come back on the ui thread.
class SchoolService final : public QObject, public SchoolAccess
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kRetry{10};

    /// @param address  of the database, which is opened by open()
    /// @param folder  of this station's own files: its key, and attempts on their way
    /// @param options  for tests
    /// @param retry  the time after which a failed request is repeated
    SchoolService(database::Address address, QString folder, database::sql::Database::Options options = {},
                  std::chrono::milliseconds retry = kRetry);
    ~SchoolService() override;

    /// What is known of the database after it was opened, or was not.
    struct Opening
    {
        core::Status status;
        bool isNew = false;     ///< nobody has been entered yet
        std::string notice;     ///< of the database
        QString soundBackup;    ///< the newest backup that can replace a damaged or missing file; empty: there is none
        core::Status restored;  ///< how restore() ended; what is there now is open, or not, in either case
        QString replaced;       ///< after it: where the old file is now; empty: there was none
    };
    using Opened = std::function<void(const Opening&)>;
    /// May be called again where it came to nothing.
    void open(QObject* owner, const Opened& done);
    /// Puts a backup in the place of the file, and opens that. Attempts of this station that were delivered after the
    /// backup was made are delivered again. Where a school is open, admins only.
    void restore(QObject* owner, const database::Login& session, const QString& backup, const Opened& done);

    void expectAlone(QObject* owner, const database::Login& session,
                     const std::function<void(const core::Status&)>& done) override;

    using SchoolAccess::ask;
    using SchoolAccess::askBeside;

    /// The same for work on the functions of database::sql.
    template <DatabaseWork Work, class Done>
    void ask(QObject* owner, Work work, Done done)
    {
        runOnDatabase(jobOf<database::sql::DatabaseContext>(owner, std::move(work), std::move(done)));
    }
    template <DatabaseWork Work, class Done>
    void askBeside(QObject* owner, Work work, Done done)
    {
        runOnDatabaseBeside(jobOf<database::sql::DatabaseContext>(owner, std::move(work), std::move(done)));
    }

    /// Puts a graded attempt into the outbox; `kept` hears whether it is on the disk. delivered() follows when the
    /// database has it, perhaps much later.
    void keep(QObject* owner, const database::Login& session, const database::AttemptRecord& attempt,
              const core::recording::Recording& recording, const std::function<void(const core::Status&)>& kept);

    /// The same for an exam that was begun.
    void keep(QObject* owner, const database::Login& session, const database::ExamStart& start,
              const std::function<void(const core::Status&)>& kept);

    void countWaiting(QObject* owner, const database::Login& session, const std::function<void(int)>& done) override;

    [[nodiscard]] int retryMs() const override { return m_retry.interval(); }

    /// Tries to deliver what waits.
    void deliver();

    /// After otherSchool(), when nobody is logged in any more: what is there now may be opened.
    void takeOtherSchool();

signals:
    /// The database has this attempt now.
    void delivered(const QString& uid);
    /// An attempt on its way is damaged; its file is kept.
    void damaged(const core::Error& error);
    /// Emitted when the person who asked has been disabled since they logged in.
    void disabled();
    /// Emitted when the person who asked is not allowed to; their role may have changed since they logged in.
    void refused();
    /// The file of another school has been put into the place of this one's; it is not opened.
    void otherSchool();
    /// So many on their way cannot be delivered to this school, or with this station's key: they wait.
    void waitOn(int count);
    /// So many on their way were put there for other schools: they wait for them.
    /// @param schools  as Outbox::schoolAt() calls them
    void waitForOthers(int count, const QString& schools);
    /// What was asked has had no answer for a while: the server hangs, or another program holds the file.
    void unanswered();
    /// What was asked was answered.
    void answered();
    /// After what was asked could not be answered, the school can be asked again.
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
    // What follows runs on the desk's thread.
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
    /// How much long work goes on beside.
    std::shared_ptr<std::atomic<int>> m_besides = std::make_shared<std::atomic<int>>(0);
    std::atomic<bool> m_allowsOthers = true;  ///< as far as is known
    QThread m_thread;
    QObject m_there;  ///< lives on m_thread
    QTimer m_retry;

    std::unique_ptr<database::sql::Database> m_database;
    std::unique_ptr<database::sql::DatabaseContext> m_school;
    std::string m_known;  ///< which school it is, as schoolOf() calls it; empty: none yet
    std::optional<database::StationKey> m_key;
    QSet<QString> m_forOthers;  ///< what waits for another school, and which
    QSet<QString> m_otherSchools;
    QTimer m_patience{this};
    int m_asked = 0;                  ///< what was asked and is not answered yet
    bool m_wasAway = false;           ///< when it was asked last
    QSet<QString> m_undeliverable;    ///< what cannot be delivered on this connection
    QHash<QString, int> m_hasFailed;  ///< what could not be delivered yet, and may be soon: as which failure of all
    int m_failures = 0;
    bool m_isLost = false;
    bool m_isDamaged = false;   ///< the file, when it was opened last
    bool m_isReadOnly = false;  ///< then
};

}  // namespace app
