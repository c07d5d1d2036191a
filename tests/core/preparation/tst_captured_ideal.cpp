// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstring>

#include "core/base/Rng.h"
#include "core/preparation/BlockPreparation.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToleranceBand.h"
#include "core/preparation/ToothPreparation.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/fuzz/Exercises.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::preparation;
using grading::Part;

namespace {

std::shared_ptr<const terrain::ToothAnatomy> molar(std::uint64_t seed = 0, int side = 150,
                                                   std::optional<teeth::CariesRule> caries = {})
{
    teeth::BuildOptions options;
    options.seed = seed;
    options.gridSide = side;
    options.caries = caries;
    return teeth::buildTooth({36}, options)->anatomy;
}

/// Returns a tooth cut to the ideal Class I preparation.
terrain::Tooth classOne(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy)
{
    const auto made = makePreparation(Kind::ClassOne, *fittedDesign(Kind::ClassOne, *anatomy), *anatomy);
    return terrain::restored(anatomy, *made->top);
}

Result<CapturedIdeal> captured(const terrain::Tooth& tooth, const Tolerances& tolerances = {})
{
    const terrain::Tooth* const one = &tooth;
    return capture(std::span(&one, 1), tolerances, {"by hand.cusprec"});
}

/// Returns the bytes of a small ideal.
std::string smallFile()
{
    return toBytes(*captured(classOne(molar(0, 64))));
}

}  // namespace

class TestCapturedIdeal : public QObject
{
    Q_OBJECT

private slots:
    void theFileIsTheIdeal()
    {
        const auto anatomy = molar(3);
        const terrain::Tooth tooth = classOne(anatomy);
        const auto ideal = captured(tooth, {0.2, 0.35, 4.0, 0.15});
        QVERIFY(support::succeeds(ideal));
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("a.cuspideal").toStdString();
        QVERIFY(writeCaptured(path, *ideal));
        const auto again = readCaptured(path);
        QVERIFY(support::succeeds(again));
        QCOMPARE(again->tooth, std::string("36"));
        QCOMPARE(again->seed, std::uint64_t{3});
        QVERIFY(again->grid == anatomy->grid);
        QVERIFY(again->tolerances == (Tolerances{0.2, 0.35, 4.0, 0.15}));
        QCOMPARE(again->sources, std::vector<std::string>{"by hand.cusprec"});
        const auto preparation = preparationOf(*again, *anatomy);
        QVERIFY(preparation);
        // The heights are those of the cut bit for bit, except cuts no deeper than a brush.
        std::size_t cut = 0;
        for (std::size_t k = 0; k < tooth.top.size(); ++k) {
            const bool isCut = preparation->parts[k] != Part::Keep;
            QVERIFY((*preparation->top)[k] == (isCut ? tooth.top[k] : anatomy->top[k]));
            cut += isCut ? 1 : 0;
        }
        QVERIFY2(cut > 1000, qPrintable(QString::number(cut)));
        const auto bytes = std::filesystem::file_size(path);
        QVERIFY(bytes < 20'000);
    }

    void aClassOneKnowsItsIsthmus()
    {
        const auto anatomy = molar();
        const auto ideal = captured(classOne(anatomy));
        QVERIFY(ideal && ideal->isthmus);
        const auto made = makePreparation(Kind::ClassOne, *fittedDesign(Kind::ClassOne, *anatomy), *anatomy);
        QVERIFY(ideal->isthmus->atMm == made->isthmus->atMm);
        // A pit elsewhere has no isthmus.
        terrain::Tooth pit(anatomy);
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (pit.isSolid(k) && at.x < anatomy->grid.nodeMm(30, 0).x - 0.001)
                pit.top[k] -= 0.5F;
        });
        const auto none = captured(pit);
        QVERIFY(support::succeeds(none));
        QVERIFY(!none->isthmus);
    }

    void fitsItsToothAlone()
    {
        const auto ideal = captured(classOne(molar()));
        QVERIFY(preparationOf(*ideal, *molar()));
        for (const auto& other : {molar(1), molar(0, 100), teeth::buildTooth({26}, {})->anatomy})
            QVERIFY(
                support::isRefused(preparationOf(*ideal, *other), "was captured on the tooth '36' (seed 0, grid 150)"));
        // An ideal also fits the tooth with decay.
        QVERIFY(preparationOf(*ideal, *molar(0, 150, teeth::CariesRule::FissureWalk)));
    }

    void refusesOddTolerances()
    {
        const terrain::Tooth tooth = classOne(molar());
        for (const Tolerances& odd : {Tolerances{-0.1, 0.2, 5, 0.1}, Tolerances{0.1, 6.0, 5, 0.1},
                                      Tolerances{0.1, 0.2, 90, 0.1}, Tolerances{0.1, 0.2, 5, std::nan("")},
                                      Tolerances{0.1, 0.2, 5, INFINITY}, Tolerances{0.1, 1.0e300, 5, 0.1}})
            QVERIFY(!captured(tooth, odd));
        QVERIFY(support::isRefused(captured(tooth, {0.1, -1.0e300, 5, 0.1}), "from 0 to 5 mm, not -1e+300"));
        QVERIFY(!capture({}, {}, {}));
        QVERIFY(!captured(terrain::Tooth(tooth.anatomy)));  // nothing was cut
    }

    void truncatedAtEveryByteIsRefused()
    {
        const std::string whole = smallFile();
        QVERIFY(capturedFrom(whole));
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const ErrorCode code = length == 0 ? ErrorCode::FileEmpty : ErrorCode::FileTruncated;
            QVERIFY(support::isRefused(capturedFrom(std::string_view(whole).substr(0, length)), code));
        }
        QVERIFY(!capturedFrom(whole + '\0'));
    }

    void everyFlippedBitIsRefused()
    {
        std::string bytes = smallFile();
        for (std::size_t k = 0; k < bytes.size(); ++k)
            for (int bit = 0; bit < 8; ++bit) {
                bytes[k] = static_cast<char>(bytes[k] ^ (1 << bit));
                QVERIFY2(!capturedFrom(bytes), qPrintable(QStringLiteral("byte %1 bit %2").arg(k).arg(bit)));
                bytes[k] = static_cast<char>(bytes[k] ^ (1 << bit));
            }
    }

    void aNewerVersionSaysSo()
    {
        std::string bytes = smallFile();
        const std::uint32_t newer = kCapturedVersion + 1;
        std::memcpy(bytes.data() + 8, &newer, sizeof newer);
        const auto refused = capturedFrom(bytes);
        QVERIFY(support::isRefused(refused, ErrorCode::NewerVersion));
        QVERIFY(support::isRefused(refused, "newer Cusp"));
    }

    void noiseIsRefused()
    {
        Rng rng(1);
        std::string noise(10 * 1024 * 1024, '\0');
        for (char& byte : noise)
            byte = static_cast<char>(rng.next() & 0xFFU);
        QVERIFY(support::isRefused(capturedFrom(noise), ErrorCode::WrongKind));
        // With a valid header, the checksum detects the damage; with a valid checksum too, the content does.
        noise.replace(0, 12, smallFile(), 0, 12);
        QVERIFY(!capturedFrom(noise));
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("noise.cuspideal").toStdString();
        support::write(path, noise);
        QVERIFY(support::isRefused(readCaptured(path), ErrorCode::FileTooLarge));
    }

    void everySentenceNamesTheFile()
    {
        QTemporaryDir folder;
        const std::string whole = smallFile();
        const std::filesystem::path path = folder.filePath("mine.cuspideal").toStdString();
        for (const std::string& bytes : {std::string(), std::string("hello"), whole.substr(0, 100), whole + "x"}) {
            support::write(path, bytes);
            QVERIFY(support::isRefused(readCaptured(path), "mine.cuspideal"));
        }
        QVERIFY(support::isRefused(readCaptured(folder.path().toStdString()), ErrorCode::FileUnreadable));
        QVERIFY(support::isRefused(readCaptured(folder.filePath("none").toStdString()), ErrorCode::FileMissing));
    }

    void theOlderFileSurvives()
    {
        QTemporaryDir folder;
        const auto ideal = captured(classOne(molar(0, 64)));
        const std::filesystem::path path = folder.filePath("a.cuspideal").toStdString();
        QVERIFY(writeCaptured(path, *ideal));
        QVERIFY(!writeCaptured(folder.path().toStdString(), *ideal));
        QVERIFY(!writeCaptured(folder.filePath("none/a.cuspideal").toStdString(), *ideal));
        QVERIFY(readCaptured(path));
    }

    /// With CUSP_REWRITE_CORPUS=1, writes the seeds of the fuzzer again: as saved, and with the packed part unpacked.
    void corpusOfTheFuzzerIsHarmless()
    {
        if (support::rewritesSeeds()) {
            const std::string bytes = smallFile();
            support::writeSeed("ideal", "saved", bytes);
            support::writeSeed("ideal", "unpacked", fuzz::unpackedIdeal(bytes));
        }
        QVERIFY(support::forEachSeed("ideal", fuzz::exerciseIdeal));
    }

    /// A straight trench with vertical walls, compared with its closed form.
    void theBandOfATrenchIsAsWideAsItsTolerance()
    {
        teeth::BlockDesign design;
        design.shape = teeth::BlockShape::Line;
        const Block block = *makeBlock(design);
        const terrain::ToothAnatomy& anatomy = *block.anatomy;
        const terrain::Grid& grid = anatomy.grid;
        constexpr double kOutlineMm = 0.3;
        constexpr double kDepthMm = 0.2;
        const ToleranceBand band = toleranceBand(anatomy, block.ideal, kOutlineMm, kDepthMm);
        // Widths across the middle of the trench: of the ideal, of what may be cut, and of what must be cut.
        double idealMm = 0.0;
        double mayMm = 0.0;
        double mustMm = 0.0;
        float floorMm = 0.0F;
        float deepestMm = 0.0F;
        float shallowestMm = 0.0F;
        for (std::size_t k = 0; k < grid.count(); ++k)
            if (block.ideal.parts[k] != Part::Keep) {
                floorMm = std::min(floorMm, (*block.ideal.top)[k]);
                deepestMm = std::min(deepestMm, band.deepestMm[k]);
                shallowestMm = std::min(shallowestMm, band.shallowestMm[k]);
            }
        for (int j = 0; j < grid.side; ++j) {
            const std::size_t k = grid.index(grid.side / 2, j);
            idealMm += block.ideal.parts[k] != Part::Keep ? grid.cellMm : 0.0;
            mayMm += band.deepestMm[k] < anatomy.top[k] ? grid.cellMm : 0.0;
            mustMm += band.shallowestMm[k] < anatomy.top[k] ? grid.cellMm : 0.0;
        }
        QVERIFY(idealMm > 0.5);
        QVERIFY(support::near(mayMm - idealMm, 2.0 * kOutlineMm, grid.cellMm));
        QVERIFY(support::near(idealMm - mustMm, 2.0 * kOutlineMm, grid.cellMm));
        QVERIFY(std::abs(deepestMm - (floorMm - 0.2F)) < 1e-5F);
        QVERIFY(std::abs(shallowestMm - (floorMm + 0.2F)) < 1e-5F);
    }

    void theBandHoldsTheIdeal()
    {
        const auto anatomy = molar();
        const auto ideal = makePreparation(Kind::ClassOne, *fittedDesign(Kind::ClassOne, *anatomy), *anatomy);
        for (const double outlineMm : {0.0, 0.1, 0.5}) {
            const ToleranceBand band = toleranceBand(*anatomy, *ideal, outlineMm, 0.1);
            for (std::size_t k = 0; k < ideal->parts.size(); ++k) {
                QVERIFY(band.deepestMm[k] <= (*ideal->top)[k]);
                QVERIFY(band.shallowestMm[k] >= (*ideal->top)[k]);
                QVERIFY(band.shallowestMm[k] <= anatomy->top[k]);
            }
        }
    }
};

CUSP_TEST(TestCapturedIdeal)
#include "tst_captured_ideal.moc"
