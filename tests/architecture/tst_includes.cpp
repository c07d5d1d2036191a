// SPDX-License-Identifier: GPL-3.0-or-later
// Compares every #include in the program's folders with the arrows between them. The table below is the truth: who
// needs a new arrow changes it there, in a commit that says why.
#include <QDirIterator>
#include <QFile>
#include <QLibraryInfo>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace {

struct Room
{
    const char* folder;      ///< the longest match in the table decides about a file
    QStringList ours;        ///< folders of ours it may include from
    QStringList notOurs;     ///< parts of those that it may not
    QStringList thirdParty;  ///< Qt modules by name ("QtCore"), other libraries by how their includes begin
    const char* ruleInWords;
};

/// What the operating system and the compiler offer beside the C++ standard library, which everyone may use.
const QStringList kSystem{"fcntl.h", "pthread.h", "pwd.h", "sched.h", "sys/", "termios.h", "time.h", "unistd.h"};

const QStringList kWindow{"QtCore",          "QtGui", "QtWidgets",      "QtOpenGL",
                          "QtOpenGLWidgets", "QtSvg", "QtPrintSupport", "glm/"};

const QList<Room> kRooms{
    {"core/",
     {"core/"},
     {"core/tracking/"},
     QStringList{"glm/", "tl/", "zstd"} + kSystem,
     "core is standard C++, GLM, tl::expected and Zstandard: no Qt, no OpenGL, no other folder"},
    {"core/tracking/",
     {"core/"},
     {},
     QStringList{"glm/", "tl/", "apriltag/", "opencv2/", "dlfcn.h"} + kSystem,
     "core/tracking is the only code that sees AprilTag and OpenCV"},
    {"haptics/",
     {"haptics/", "core/"},
     {},
     QStringList{"glm/", "sodium", "libusb-1.0/", "SDL.h"} + kSystem,
     "haptics sees core, libsodium, libusb and SDL 2: no Qt, no window"},
    {"lab/", {"lab/", "haptics/", "core/"}, {}, {"glm/"}, "lab sees core and haptics: no Qt, no window"},
    {"lessons/",
     {"lessons/", "core/"},
     {},
     {"QtCore", "glm/"},
     "lessons sees core and QtCore: it opens no window and no database"},
    {"database/",
     {"database/", "lessons/", "core/"},
     {},
     QStringList{"QtCore", "QtSql", "sodium", "sqlite3", "zxcvbn.h"} + kSystem,
     "database sees lessons, core, QtCore, QtSql, SQLite, libsodium and zxcvbn: it shows nothing"},
    {"ui/",
     {"ui/", "database/", "lessons/", "core/"},
     {"database/sql/"},
     kWindow,
     "ui sees core, lessons, the interfaces of database and Qt: it names no device and writes no SQL"},
    {"ui/render/",
     {"ui/render/", "core/"},
     {},
     {"QtCore", "QtGui", "QtOpenGL", "glm/"},
     "ui/render is OpenGL only: it sees core and Qt's OpenGL, no widgets and no other part of ui"},
    {"ui/sound/",
     {"ui/sound/", "core/"},
     {},
     {"QtCore", "QtMultimedia"},
     "ui/sound plays what core/audio makes: it alone sees Qt Multimedia, and it shows nothing"},
    {"app/",
     {"app/", "ui/", "haptics/", "database/", "lessons/", "core/"},
     {},
     QStringList{"Qt", "glm/"} + kSystem,
     "app sees all rooms but lab, bench and cli; the libraries behind haptics and core stay behind them"},
    {"bench/",
     {"bench/", "cli/parts/", "app/", "ui/", "lab/", "haptics/", "database/", "lessons/", "core/"},
     {},
     QStringList{"Qt", "glm/"} + kSystem,
     "bench measures everything below it, and lab with it"},
    {"cli/",
     {"cli/", "bench/", "app/", "ui/", "haptics/", "database/", "lessons/", "core/"},
     {},
     QStringList{"Qt", "glm/"} + kSystem,
     "cli is the roof: commands, and main(); it reaches lab through bench alone"},
};

const QStringList kFolders{"core", "haptics", "lab", "lessons", "database", "ui", "app", "bench", "cli"};

/// The folders from which the sources of one folder may include; their own folder is always allowed.
struct Arrows
{
    QString folder;
    QString to;  ///< separated by spaces
};

/// One row per folder, each below the rows that it may include from. docs/ARCHITECTURE.md draws them.
const QList<Arrows> kArrows{
    {"core/base", ""},
    {"core/rt", ""},
    {"core/mesh", "core/base"},
    {"core/tracking", "core/base core/rt"},
    {"core/terrain", "core/mesh"},
    {"core/tracking/pictures", "core/tracking"},
    {"core/bur", "core/base core/terrain"},
    {"core/teeth", "core/base core/mesh core/terrain"},
    {"core/contact", "core/base core/bur core/terrain"},
    {"core/imaging", "core/base core/bur core/teeth core/terrain"},
    {"core/settings", "core/base core/contact core/terrain"},
    {"core/cutting", "core/bur core/contact core/settings"},
    {"core/servo", "core/contact core/cutting core/rt core/settings core/terrain"},
    {"core/audio", "core/servo core/settings core/terrain"},
    {"core/grading", "core/base core/bur core/cutting core/servo core/teeth core/terrain"},
    {"core/guidance", "core/bur core/grading core/teeth"},
    {"core/history", "core/grading core/servo core/terrain"},
    {"core/recording", "core/base core/bur core/history core/servo core/terrain"},
    {"core/preparation", "core/base core/bur core/grading core/recording core/teeth core/terrain"},
    {"core/session", "core/audio core/base core/grading core/guidance core/history core/recording core/rt core/servo "
                     "core/settings core/terrain"},
    {"lessons", "core/base core/bur core/grading core/guidance core/mesh core/preparation core/recording core/servo "
                "core/session core/settings core/teeth core/terrain"},
    {"haptics/pedal", "core/base core/session core/settings"},
    {"haptics", "core/audio core/contact core/guidance core/rt core/servo core/session haptics/pedal"},
    {"haptics/falcon", "core/base core/contact core/rt core/session haptics"},
    {"haptics/pointer", "core/rt core/servo haptics"},
    {"haptics/simulated", "core/base core/bur core/grading core/recording core/rt core/servo core/session core/terrain "
                          "haptics haptics/falcon haptics/pointer"},
    {"lab", "core/base core/bur core/contact core/cutting core/servo core/terrain core/tracking haptics haptics/falcon "
            "haptics/simulated"},
    {"database", "core/base core/recording lessons"},
    {"database/sql", "core/base lessons database"},
    {"ui/render", "core/base core/bur core/grading core/servo core/teeth core/terrain"},
    {"ui/sound", "core/audio core/rt"},
    {"ui/text", "core/base core/bur core/servo core/settings core/teeth core/terrain lessons database"},
    {"ui/kit", "core/bur core/settings core/terrain ui/render ui/text"},
    {"ui/admin", "core/base database ui/kit ui/text"},
    {"ui/charts", "ui/kit ui/text"},
    {"ui/devices", "core/base core/session core/settings core/tracking ui/kit ui/sound ui/text"},
    {"ui/inside",
     "core/bur core/grading core/imaging core/preparation core/servo core/teeth core/terrain ui/kit ui/text"},
    {"ui/tooth", "core/base core/bur core/servo core/session core/settings core/teeth core/terrain core/tracking "
                 "ui/kit ui/render ui/text"},
    {"ui/practice", "core/bur core/grading core/guidance core/history core/imaging core/servo core/session "
                    "core/terrain lessons ui/kit ui/render ui/text ui/tooth"},
    {"ui/presets", "core/base core/bur core/cutting core/settings lessons ui/charts ui/kit ui/text"},
    {"ui/toothchooser", "ui/kit ui/render ui/text ui/tooth"},
    {"ui/console", "core/base core/servo core/settings ui/charts ui/kit ui/presets ui/text ui/tooth"},
    {"ui/replay", "core/bur core/grading core/servo core/session ui/kit ui/practice ui/text"},
    {"ui/scoring", "core/grading core/imaging core/terrain lessons database ui/charts ui/inside ui/kit ui/practice "
                   "ui/render ui/text"},
    {"ui/catalog", "core/grading core/imaging core/preparation core/terrain lessons database ui/inside ui/kit "
                   "ui/scoring ui/text ui/toothchooser"},
    {"ui/people", "lessons database ui/charts ui/kit ui/scoring ui/text"},
    {"ui/settings", "core/settings ui/console ui/kit ui/text"},
    {"ui/lessoneditor", "core/base core/preparation lessons ui/catalog ui/charts ui/inside ui/kit ui/text"},
    {"ui/report", "lessons database ui/charts ui/kit ui/people ui/scoring ui/text"},
    {"ui/window", "core/base core/bur core/grading core/guidance core/imaging core/servo core/session core/settings "
                  "core/teeth core/terrain "
                  "lessons database ui/admin ui/catalog ui/console ui/devices ui/inside ui/kit ui/lessoneditor "
                  "ui/people ui/practice ui/presets ui/replay ui/scoring ui/settings ui/text ui/tooth ui/toothchooser"},
    {"app/threads", "core/rt core/session haptics"},
    {"app/school", "core/base core/recording lessons database database/sql app/threads"},
    {"app/devices", "core/base core/tracking core/settings core/session haptics/pedal haptics "
                    "haptics/falcon ui/sound ui/text ui/kit ui/devices ui/tooth ui/practice ui/window "
                    "app/threads"},
    {"app/pages", "core/base core/settings core/recording lessons database ui/text ui/kit ui/admin "
                  "ui/scoring ui/catalog ui/people ui/report ui/window app/threads app/school"},
    {"app/attempt", "core/rt core/bur core/teeth core/settings core/servo core/grading core/guidance "
                    "core/history core/recording core/preparation core/session lessons haptics/falcon "
                    "haptics/pointer haptics/simulated database ui/render ui/text ui/kit ui/tooth ui/scoring "
                    "ui/window app/threads app/school app/devices app/pages"},
    {"app/replay", "core/rt core/servo core/audio core/history core/recording core/session lessons "
                   "haptics ui/tooth ui/scoring ui/replay ui/window app/threads app/devices app/pages app/attempt"},
    {"app", "core/base core/teeth core/servo core/session haptics haptics/pointer "
            "haptics/simulated database database/sql ui/sound ui/text ui/devices ui/tooth "
            "ui/scoring ui/people ui/window app/threads app/school app/devices app/pages app/attempt app/replay"},
    {"cli/parts", "core/base core/tracking core/bur core/teeth core/settings core/servo core/grading "
                  "lessons haptics/falcon haptics/simulated database database/sql ui/devices app/devices"},
    {"bench", "core/base core/rt core/tracking core/terrain core/bur core/teeth core/contact "
              "core/settings core/servo core/audio core/guidance core/recording core/session lessons "
              "haptics haptics/falcon haptics/pointer haptics/simulated lab ui/render ui/sound "
              "ui/kit ui/charts ui/tooth app/threads app/attempt app/replay cli/parts"},
    {"cli/render", "core/base core/bur core/grading core/imaging core/servo core/teeth core/terrain ui/inside "
                   "ui/render ui/tooth cli/parts"},
    {"cli", "core/base core/mesh core/tracking core/bur core/teeth core/settings core/servo "
            "core/audio core/recording core/preparation core/session lessons haptics "
            "haptics/falcon haptics/pointer haptics/simulated database database/sql ui/render "
            "ui/text ui/kit ui/inside ui/tooth ui/catalog ui/devices app/threads app/school app/devices "
            "app/attempt app cli/parts bench cli/render"},
};

const Arrows* arrowsOf(const QString& folder)
{
    const auto found =
        std::find_if(kArrows.begin(), kArrows.end(), [&](const Arrows& row) { return row.folder == folder; });
    return found == kArrows.end() ? nullptr : &*found;
}

QString folderOf(const QString& file)
{
    return file.section('/', 0, -2);
}

const Room* roomOf(const QString& file)
{
    const Room* best = nullptr;
    for (const Room& room : kRooms)
        if (file.startsWith(room.folder) && (best == nullptr || qstrlen(room.folder) > qstrlen(best->folder)))
            best = &room;
    return best;
}

bool startsWithAny(const QString& text, const QStringList& beginnings)
{
    return std::any_of(beginnings.begin(), beginnings.end(), [&](const QString& b) { return text.startsWith(b); });
}

/// "QtWidgets" for QLabel, QtWidgets/QLabel and qlabel.h; empty for what is not Qt's.
QString qtModuleOf(const QString& include)
{
    static const QDir headers(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    static const QStringList modules = headers.entryList({"Qt*"}, QDir::Dirs);
    if (QString folder = include.section('/', 0, 0); include.contains('/') && folder.startsWith("Qt"))
        return folder;
    for (const QString& module : modules)
        if (headers.exists(module + '/' + include))
            return module;
    // A Qt class that is not installed here is still Qt's, of a module nobody was allowed.
    static const QRegularExpression qtClass("^Q[A-Z]\\w*$");
    return qtClass.match(include).hasMatch() ? QStringLiteral("Qt of an unknown module") : QString();
}

/// The rule that this line breaks, in words; empty when the line is no #include or an allowed one.
QString complaint(const QString& file, const QString& line)
{
    static const QRegularExpression directive("^\\s*#\\s*include\\b\\s*(.*)$");
    static const QRegularExpression name("^([<\"])([^>\"]+)[>\"]");
    const auto isInclude = directive.match(line);
    if (!isInclude.hasMatch())
        return {};
    const auto parts = name.match(isInclude.captured(1));
    if (!parts.hasMatch())
        return "an include names its file: no macros";
    const bool quoted = parts.captured(1) == "\"";
    const QString include = parts.captured(2);
    const Room& room = *roomOf(file);

    if (quoted) {
        if (include == QFileInfo(file).completeBaseName() + ".moc")
            return {};
        if (roomOf(include) == nullptr)
            return "\"\" is for our own files, written from the root of the repository (\"core/base/Result.h\")";
        if (!startsWithAny(include, room.ours) || startsWithAny(include, room.notOurs))
            return room.ruleInWords;
        const Arrows* arrows = arrowsOf(folderOf(file));
        if (arrows == nullptr)
            return "this folder has no row in kArrows (tests/architecture/tst_includes.cpp)";
        const bool isDrawn = folderOf(include) == folderOf(file) || arrows->to.split(' ').contains(folderOf(include));
        return isDrawn ? QString() : QString("%1 may include from: %2").arg(arrows->folder, arrows->to);
    }
    if (roomOf(include) != nullptr)
        return "our own files are included with \"\", not with <>";
    static const QRegularExpression standard("^[a-z_]+$");
    if (const QString module = qtModuleOf(include); !module.isEmpty())
        return room.thirdParty.contains(module) || room.thirdParty.contains("Qt") ? QString()
                                                                                  : QString(room.ruleInWords);
    const bool allowed = standard.match(include).hasMatch() || startsWithAny(include, room.thirdParty);
    return allowed ? QString() : QString(room.ruleInWords);
}

/// Whether a line of the window's puts a box before it, which stops all else until it is answered. What is to be said
/// or asked stands within the page: MessageBar, ConfirmOverlay. Where to save and what to print on is asked by
/// FileDialog and QPrintDialog, by open(), beside which the window goes on.
bool putsABox(QString line)
{
    static const QRegularExpression box(
        "\\bQ(MessageBox|ErrorMessage|InputDialog|ProgressDialog|Wizard|ColorDialog|FontDialog)\\b|"
        "\\bQFileDialog::get|\\b(public|new) QDialog\\b|\\bQDialog \\w+[;({]|"
        "\\bsetModal\\b|\\b(Application|Window)Modal\\b|\\bQEventLoop \\w");
    static const QRegularExpression waits("(\\w+::)?\\bexec\\(");
    line = line.section("//", 0, 0);
    if (line.contains(box))
        return true;
    const auto wait = waits.match(line);
    return wait.hasMatch() && wait.captured(1) != "QApplication::";
}

/// Reads each source file of these folders: its name from the root of the repository, and its text.
template <class Use>
void forEachSource(const QStringList& folders, Use&& use)
{
    const QDir root(CUSP_SOURCE_DIR);
    for (const QString& folder : folders) {
        QDirIterator it(root.filePath(folder),
                        {"*.h", "*.hpp", "*.inc", "*.inl", "*.ipp", "*.c", "*.cc", "*.cpp", "*.cxx"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile source(it.next());
            QVERIFY2(source.open(QIODevice::ReadOnly), qPrintable(source.fileName()));
            use(root.relativeFilePath(source.fileName()), QString::fromUtf8(source.readAll()));
        }
    }
}

}  // namespace

class TestIncludes : public QObject
{
    Q_OBJECT

private slots:
    void plantedLines_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("line");
        QTest::addColumn<bool>("allowed");
        const auto plant = [](const char* file, const QStringList& allowed, const QStringList& refused) {
            for (const QString& include : allowed + refused)
                QTest::newRow(qPrintable(file + (": " + include)))
                    << file << "#include " + include << allowed.contains(include);
        };
        plant("core/mesh/A.cpp", {"<vector>", "\"core/mesh/A.h\""},
              {"<assimp/Importer.hpp>", "<QString>", "<qglobal.h>", "<GL/gl.h>", "<opencv2/core.hpp>",
               "\"lessons/ScoreSheet.h\"", "\"A.h\"", "<core/mesh/A.h>", "SOME_HEADER"});
        plant("haptics/A.cpp", {"\"core/rt/SpscQueue.h\""},
              {"<QObject>", "\"ui/text/Texts.h\"", "\"lab/StiffnessLimit.h\""});
        plant("lab/A.cpp", {"\"haptics/HapticDevice.h\""}, {"<QObject>"});
        plant("lessons/A.cpp", {"<QJsonDocument>"}, {"<QImage>", "\"database/AttemptRecord.h\""});
        plant("database/sql/A.cpp", {"<QSqlQuery>"}, {"<QMessageBox>"});
        plant("database/sql/A.h", {"\"lessons/ScoreSheet.h\""}, {"\"ui/text/Texts.h\""});
        plant("ui/people/A.cpp", {"<QOpenGLWidget>", "\"database/AttemptRecord.h\"", "\"A.moc\""},
              {"\"database/sql/Attempts.h\"", "<QSqlQuery>", "\"haptics/HapticDevice.h\"", "\"cli/Commands.h\"",
               "\"B.moc\""});
        plant("ui/render/A.cpp", {"<QOpenGLBuffer>"}, {"<QWidget>", "<QOpenGLWidget>", "\"ui/tooth/Camera.h\""});
        plant("core/terrain/A.cpp", {"\"core/mesh/A.h\""}, {"\"core/contact/LiveTooth.h\""});
        plant("ui/kit/A.cpp", {"\"ui/text/Texts.h\""}, {"\"ui/window/MainWindow.h\"", "\"ui/tooth/Camera.h\""});
        plant("app/A.cpp", {"\"haptics/HapticDevice.h\"", "<QApplication>"},
              {"<libusb-1.0/libusb.h>", "\"tests/support/Allocations.h\""});
        QTest::newRow("spaces") << "core/mesh/A.cpp"
                                << "  #  include <QtCore/qglobal.h>" << false;
        QTest::newRow("a comment") << "core/mesh/A.cpp"
                                   << "// talks about #include <QString>" << true;
    }

    void plantedLines()
    {
        QFETCH(QString, file);
        QFETCH(QString, line);
        QFETCH(bool, allowed);
        QCOMPARE(complaint(file, line).isEmpty(), allowed);
    }

    void theQtHeadersAreFound()
    {
        QCOMPARE(qtModuleOf("QString"), QString("QtCore"));
        QCOMPARE(qtModuleOf("QTest"), QString("QtTest"));
        QCOMPARE(qtModuleOf("vector"), QString());
    }

    /// So no two folders include each other, not even through a third.
    void arrowsPointUpwardsInTheTable()
    {
        QStringList above;
        for (const Arrows& row : kArrows) {
            QVERIFY2(!above.contains(row.folder), qPrintable(row.folder));
            for (const QString& to : row.to.split(' ', Qt::SkipEmptyParts))
                QVERIFY2(above.contains(to), qPrintable(row.folder + " includes " + to + ", which stands below it"));
            above << row.folder;
        }
    }

    /// A row that is no longer used would let an include back in that was removed.
    void everyArrowIsUsed()
    {
        QMap<QString, QSet<QString>> used;
        forEachSource(kFolders, [&](const QString& name, const QString& text) {
            static const QRegularExpression include("^#include \"([^\"]+)\"", QRegularExpression::MultilineOption);
            for (auto it = include.globalMatch(text); it.hasNext();)
                used[folderOf(name)] << folderOf(it.next().captured(1));
        });
        for (const Arrows& row : kArrows)
            for (const QString& to : row.to.split(' ', Qt::SkipEmptyParts))
                QVERIFY2(used[row.folder].contains(to), qPrintable(row.folder + " no longer includes " + to));
    }

    void everyIncludeFollowsAnArrow_data()
    {
        QTest::addColumn<QString>("folder");
        for (const QString& folder : kFolders)
            QTest::newRow(qPrintable(folder)) << folder;
    }

    void everyIncludeFollowsAnArrow()
    {
        QFETCH(QString, folder);
        int files = 0;
        QStringList complaints;
        forEachSource({folder}, [&](const QString& name, const QString& text) {
            ++files;
            for (int number = 1; const QString& line : text.split('\n')) {
                if (const QString rule = complaint(name, line.trimmed()); !rule.isEmpty())
                    complaints << QString("%1:%2: %3\n    %4").arg(name).arg(number).arg(line, rule);
                ++number;
            }
        });
        QVERIFY2(files > 0, "no source files were found: is CUSP_SOURCE_DIR right?");
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
    }

    /// QSaveFile::commit() does not notice when the last 16 kB find no room on the disk: it gives an empty file its
    /// name (Qt 6.4). So each caller of commit() calls flush() before.
    void whatIsSavedWasWritten()
    {
        int files = 0;
        forEachSource(kFolders, [&](const QString& name, const QString& text) {
            if (!text.contains("QSaveFile "))  // has one of its own
                return;
            ++files;
            const auto commits = text.count(".commit()");
            QVERIFY2(commits > 0 && text.count(".flush()") >= commits, qPrintable(name));
        });
        QVERIFY(files > 0);
    }

    void plantedBoxes_data()
    {
        QTest::addColumn<bool>("isBox");
        for (const char* box :
             {"QMessageBox::warning(this, title, words);", "#include <QMessageBox>",
              "QInputDialog::getText(this, title, label);", "const QString file = QFileDialog::getOpenFileName(this);",
              "class Question : public QDialog", "auto* box = new QDialog(this);", "QDialog box(this);",
              "dialog->exec();", "menu.exec(QCursor::pos());", "setWindowModality(Qt::ApplicationModal);",
              "QEventLoop loop;"})
            QTest::newRow(box) << true;
        for (const char* none : {"return QApplication::exec();", "dialog->open();", "// instead of a QMessageBox",
                                 "connect(dialog, &QDialog::accepted, this, done);",
                                 "class FileDialog : public QFileDialog", "m_console->execute(command);"})
            QTest::newRow(none) << false;
    }

    void plantedBoxes()
    {
        QFETCH(bool, isBox);
        QCOMPARE(putsABox(QTest::currentDataTag()), isBox);
    }

    void thePageSpeaksAndNoBox()
    {
        int files = 0;
        QStringList boxes;
        forEachSource({"ui", "app", "cli"}, [&](const QString& name, const QString& text) {
            ++files;
            for (int number = 1; const QString& line : text.split('\n')) {
                if (putsABox(line.trimmed()))
                    boxes << QString("%1:%2: %3").arg(name).arg(number).arg(line);
                ++number;
            }
        });
        QVERIFY(files > 100);
        QVERIFY2(boxes.isEmpty(), qPrintable('\n' + boxes.join('\n')));
    }
};

QTEST_GUILESS_MAIN(TestIncludes)
#include "tst_includes.moc"
