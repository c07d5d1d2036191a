// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QMargins>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;

namespace {

const QString kReferences = QStringLiteral(CUSP_SOURCE_DIR "/tests/pictures/");
const QString kFailed = QStringLiteral(CUSP_BINARY_DIR "/tests/pictures/");

/// Two pictures are compared at a quarter of their width and height, because drivers may draw an edge half a pixel
/// further or with a harder edge.
constexpr int kShrink = 4;
/// A pixel is near if each of its channels differs by at most this much, of 255.
constexpr int kNear = 20;
/// The share of pixels that may be further away, and the largest difference of a channel's mean over all pixels. Two of
/// Mesa's drivers differ by 0.02 percent and a mean of 0.03. The smallest difference that a person would notice, one
/// tooth of 32 marked, is half a percent; a wet tooth in place of a dry one differs by a mean of 2.3.
constexpr double kMostAway = 0.003;
constexpr double kMeanNear = 1.5;

/// Margins that contain text: around a section, and at the right of the colour scale of depths. They are not compared,
/// because the fonts depend on the computer.
constexpr QMargins kWords(32, 24, 8, 68);
constexpr QMargins kScale(0, 0, 180, 0);

/// The subject of a picture.
enum class Of { Tooth, Cutting, Cut, Nothing };

/// One picture. Together they cover everything that `cusp render` can show or hide.
struct Row
{
    const char* name;
    Of of;
    const char* options;
    const char* unlike = nullptr;  ///< name of a row whose picture must differ visibly from this one
    QMargins words = {};           ///< margins with text, which are not compared
};
constexpr std::array kRows{
    Row{"tooth", Of::Tooth, ""},
    // Views.
    Row{"occlusal", Of::Tooth, "--view occlusal"},
    Row{"buccal", Of::Tooth, "--view buccal"},
    Row{"lingual", Of::Tooth, "--view lingual", "buccal"},
    Row{"mesial", Of::Tooth, "--view mesial"},
    Row{"distal", Of::Tooth, "--view distal", "mesial"},
    Row{"below", Of::Tooth, "--view below"},
    // Orientation.
    Row{"mirror", Of::Tooth, "--show mirror", "tooth"},
    Row{"neighbours", Of::Tooth, "--show neighbours", "tooth"},
    Row{"instrument", Of::Cutting, "", "tooth"},
    Row{"instrument-away", Of::Cut, "", "instrument"},
    Row{"instrument-mirror", Of::Cutting, "--show mirror,neighbours", "instrument"},
    Row{"hand", Of::Cutting, "--show hand,gizmo"},
    Row{"arrow", Of::Cut, "--show hand --view 20,70,9"},
    Row{"left-hand", Of::Cutting, "--show left-hand,mirror"},
    Row{"red-cyan", Of::Cutting, "--stereo red-cyan", "instrument"},
    Row{"grey", Of::Cutting, "--stereo grey", "red-cyan"},
    Row{"side-by-side", Of::Cutting, "--stereo side-by-side", "instrument"},
    Row{"top-bottom", Of::Cutting, "--stereo top-bottom", "side-by-side"},
    Row{"left-right", Of::Cutting, "--flip left-right", "instrument"},
    Row{"up-down", Of::Cutting, "--flip up-down", "instrument"},
    Row{"both-flips", Of::Cutting, "--flip both", "left-right"},
    Row{"arch", Of::Nothing, "--arch"},
    Row{"arch-36", Of::Nothing, "--arch --tooth 36", "arch"},
    // A drilled cavity in close-up.
    Row{"cavity", Of::Cut, "--view 20,60,14"},
    Row{"cavity-distinct", Of::Cut, "--view 20,60,14 --show distinct", "cavity"},
    Row{"cavity-wet", Of::Cut, "--view 20,60,14 --show wet", "cavity"},
    Row{"cavity-depth", Of::Cut, "--view 20,60,14 --show depth", "cavity", kScale},
    Row{"cavity-ideal", Of::Cut, "--view 20,60,14 --show ideal", nullptr, kScale},
    Row{"ideal", Of::Tooth, "--show ideal", nullptr, kScale},
    Row{"drilling", Of::Cutting, "--view 20,40,14"},
    Row{"drilling-light", Of::Cutting, "--view 20,40,14 --show light", "drilling"},
    // The inside of the tooth.
    Row{"section-0", Of::Cutting, "--section 0", nullptr, kWords},
    Row{"section-90", Of::Cutting, "--section 90", "section-0", kWords},
    Row{"section-distinct", Of::Cutting, "--section 90 --show distinct", "section-90", kWords},
    Row{"xray", Of::Cut, "--xray"},
    Row{"xray-before", Of::Cut, "--xray --show before"},
    Row{"xray-turned", Of::Cut, "--xray --angle 40 --exposure 2"},
    Row{"bitewing", Of::Cut, "--bitewing"},
    Row{"bitewing-sound", Of::Tooth, "--bitewing --caries none", "bitewing"},
};

struct Difference
{
    double away = 1.0;    ///< share of the pixels that are not near
    double mean = 255.0;  ///< difference of the channel whose mean differs most
    QImage picture;       ///< four times the difference; red where a pixel is not near
    [[nodiscard]] bool isSmall() const { return away <= kMostAway && mean <= kMeanNear; }
    [[nodiscard]] QString words() const
    {
        return QStringLiteral("%1 % of the picture and the mean by %2")
            .arg(100.0 * away, 0, 'f', 2)
            .arg(mean, 0, 'f', 2);
    }
};

/// Compares two pictures of a row. Pictures of different sizes count as different everywhere.
Difference difference(const Row& row, const QImage& one, const QImage& other)
{
    const auto shrunk = [&](const QImage& picture) {
        const QRect compared = picture.rect().marginsRemoved(row.words);
        return picture.copy(compared)
            .convertToFormat(QImage::Format_RGB32)
            .scaled(compared.size() / kShrink, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    Difference found;
    if (one.isNull() || one.size() != other.size())
        return found;
    const QImage a = shrunk(one);
    const QImage b = shrunk(other);
    found.picture = QImage(a.size(), QImage::Format_RGB32);
    std::array<double, 3> sum{};
    int notNear = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            const std::array<int, 3> by{qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)};
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += by[c];
                most = std::max(most, std::abs(by[c]));
            }
            notNear += most > kNear ? 1 : 0;
            const int shown = std::min(255, 4 * most);
            found.picture.setPixel(x, y, most > kNear ? qRgb(255, shown / 3, shown / 3) : qRgb(shown, shown, shown));
        }
    }
    const double pixels = static_cast<double>(a.width()) * a.height();
    found.away = notNear / pixels;
    found.mean = 0.0;
    for (const double each : sum)
        found.mean = std::max(found.mean, std::abs(each) / pixels);
    return found;
}

QImage reference(const QString& name)
{
    return QImage(kReferences + name + ".png");
}

bool isRewriting()
{
    return std::getenv("CUSP_REWRITE_PICTURES") != nullptr;
}

}  // namespace

/// Compares the pictures of `cusp render` with references that a person has checked: tests/pictures/README.md.
class TestPictures : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(QDir().mkpath(kFailed));
        record("cutting", -4.2, true);
        record("cut", 30.0, false);
    }

    void looksAsItDid_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t k = 0; k < kRows.size(); ++k)
            QTest::newRow(kRows[k].name) << static_cast<int>(k);
    }

    void looksAsItDid()
    {
        QFETCH(int, row);
        const Row& what = kRows.at(static_cast<std::size_t>(row));
        const QString name = QString::fromLatin1(what.name);
        const QString drawn = kFailed + name + ".png";
        const QString differs = kFailed + name + "-difference.png";
        const Ending ending = draw(what, drawn);
        expectDone(ending);
        const QImage picture(drawn);
        if (isRewriting())
            QVERIFY(picture.save(kReferences + name + ".png", "PNG", 0));
        const QImage wanted = reference(name);
        QVERIFY2(!wanted.isNull(), qPrintable(QStringLiteral("there is no %1%2.png; look at %3 and then let "
                                                             "CUSP_REWRITE_PICTURES=1 make it")
                                                  .arg(kReferences, name, drawn)));
        const Difference found = difference(what, picture, wanted);
        if (!found.isSmall() && !found.picture.isNull())
            QVERIFY(found.picture.scaled(found.picture.size() * kShrink).save(differs));
        QVERIFY2(found.isSmall(), qPrintable(QStringLiteral("%1 differ; drawn: %2, difference: %3, reference: %4%5.png")
                                                 .arg(found.words(), drawn, differs, kReferences, name)));
        QFile::remove(drawn);
        QFile::remove(differs);
        // The comparison must notice that the subject of the picture is missing.
        if (what.unlike != nullptr) {
            const Difference seen = difference(what, reference(what.unlike), wanted);
            QVERIFY2(!seen.picture.isNull() && !seen.isSmall(), qPrintable(what.unlike + (": " + seen.words())));
        }
    }

    /// Every reference belongs to a row, so that no unused file is maintained.
    void referencesAreOfRows()
    {
        QStringList rows;
        for (const Row& row : kRows)
            rows << QString::fromLatin1(row.name) + ".png";
        rows.sort();
        qint64 bytes = 0;
        const QFileInfoList files = QDir(kReferences).entryInfoList({"*.png"}, QDir::Files, QDir::Name);
        QStringList names;
        for (const QFileInfo& file : files) {
            names << file.fileName();
            bytes += file.size();
        }
        names.sort();
        QCOMPARE(names, rows);
        QVERIFY2(bytes < 3'000'000, qPrintable(QString::number(bytes)));
    }

    /// Mesa's simplest driver draws without antialiasing. Where the system's OpenGL is not Mesa, its own driver draws a
    /// second time.
    void survivesAnotherDriver()
    {
        for (const Row& row : kRows) {
            if (!QStringList{"tooth", "arch", "drilling-light"}.contains(row.name))
                continue;
            const QString file = m_folder.filePath("softpipe.png");
            if (draw(row, file, {"GALLIUM_DRIVER=softpipe"}).exitCode != 0)
                QSKIP("This computer has no second driver.");
            const Difference found = difference(row, QImage(file), reference(row.name));
            QVERIFY2(found.isSmall(), qPrintable(row.name + (": " + found.words())));
        }
    }

    /// A display that is gone, or one that Qt would choose first, does not keep the tooth from being drawn.
    void otherDisplays_data()
    {
        QTest::addColumn<QStringList>("environment");
        const QString x11 = "DISPLAY=" + qEnvironmentVariable("DISPLAY");
        const QString wayland = "WAYLAND_DISPLAY=wayland-4711";
        QTest::newRow("a stale DISPLAY") << QStringList{"DISPLAY=:4711"};
        QTest::newRow("nothing but a stale WAYLAND_DISPLAY") << QStringList{wayland};
        QTest::newRow("a stale WAYLAND_DISPLAY") << QStringList{x11, wayland, "XDG_SESSION_TYPE=wayland"};
        QTest::newRow("Wayland asked for") << QStringList{x11, "QT_QPA_PLATFORM=wayland"};
        QTest::newRow("no window asked for") << QStringList{x11, "QT_QPA_PLATFORM=offscreen"};
        QTest::newRow("no window, with options") << QStringList{x11, "QT_QPA_PLATFORM=offscreen:x=1"};
        QTest::newRow("a platform without OpenGL") << QStringList{x11, "QT_QPA_PLATFORM=linuxfb"};
        QTest::newRow("a platform that Qt does not know") << QStringList{"QT_QPA_PLATFORM=nonsense"};
    }
    void otherDisplays()
    {
        QFETCH(const QStringList, environment);
        const QString file = m_folder.filePath("other.png");
        QFile::remove(file);
        expectDone(runCusp({"render", "--size", "480x300", "--tooth", "36", "--out", file}, environment));
        QCOMPARE(QImage(file).size(), QSize(480, 300));
    }

private:
    /// Records an attempt on tooth 36: a box through enamel and lesion into dentin.
    /// @param atEndMm  height at which the hand holds the bur at the end
    void record(const QString& name, double atEndMm, bool drilling)
    {
        QByteArray path("t_s,x_mm,y_mm,z_mm,drill\n0,-2,0,3,1\n");
        double t = 0.4;
        const auto go = [&](double seconds, double x, double y, double z, bool drills) {
            t += seconds;
            path += QStringLiteral("%1,%2,%3,%4,%5\n").arg(t).arg(x).arg(y).arg(z).arg(drills ? 1 : 0).toLatin1();
        };
        double x = -2.0;
        for (const double z : {-3.0, -3.6, -4.2}) {
            for (const double y : {-0.7, -0.35, 0.0, 0.35, 0.7}) {
                go(0.15, x, y, z, true);
                x = -x;
                go(0.8, x, y, z, true);
            }
        }
        go(0.6, 0.4, 0.2, atEndMm, drilling);
        go(0.2, 0.4, 0.2, atEndMm, drilling);
        QFile file(m_folder.filePath(name + ".csv"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(path) == path.size());
        file.close();
        expectDone(runCusp({"simulate", "--tooth", "36", "--path", file.fileName(), "--out",
                            m_folder.filePath(name + ".trace"), "--record", m_folder.filePath(name + ".cusprec")}));
    }

    [[nodiscard]] Ending draw(const Row& row, const QString& file, const QStringList& environment = {}) const
    {
        QStringList arguments{"render", "--size", "480x300", "--out", file};
        if (row.of == Of::Tooth)
            arguments << "--tooth"
                      << "36";
        if (row.of == Of::Cutting || row.of == Of::Cut)
            arguments << "--recording" << m_folder.filePath(row.of == Of::Cut ? "cut.cusprec" : "cutting.cusprec");
        arguments << QString::fromLatin1(row.options).split(u' ', Qt::SkipEmptyParts);
        QStringList settings = environment;
        if (const QString display = qEnvironmentVariable("DISPLAY"); !display.isEmpty())
            settings << "DISPLAY=" + display;
        return runCusp(arguments, settings);
    }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestPictures)
#include "tst_pictures.moc"
