// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <QTemporaryDir>

#include "core/imaging/Bitewing.h"
#include "core/imaging/Radiograph.h"
#include "core/mesh/ObjWriter.h"
#include "core/mesh/Placement.h"
#include "core/preparation/ToothPreparation.h"
#include "core/recording/Format.h"
#include "core/teeth/Laid.h"
#include "core/teeth/LesionSite.h"
#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothGenerator.h"
#include "core/teeth/ToothTable.h"
#include "core/terrain/Lying.h"
#include "core/terrain/Tooth.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"

using namespace core;
using teeth::LesionSite;
using terrain::Lying;
using terrain::ToothAnatomy;
using terrain::ToothSide;

namespace {

/// Makes a tooth that lies on a side.
Result<teeth::BuiltTooth> laidTooth(int fdi, const char* side, double tiltDeg = 90.0, double extent = 0.0,
                                    std::optional<LesionSite> site = {}, std::uint64_t seed = 0)
{
    const auto lying = teeth::findLying(side, tiltDeg, fdi);
    if (!lying)
        return tl::unexpected(lying.error());
    teeth::BuildOptions options;
    options.lying = *lying;
    options.seed = seed;
    options.site = site;
    options.cariesExtent = extent;
    if (extent <= 0.0)
        options.caries.reset();
    return teeth::buildTooth({fdi}, options);
}

bool isSolid(const ToothAnatomy& tooth, std::size_t k)
{
    return tooth.top[k] > tooth.bottom[k];
}

/// Returns the largest z of the surface in the tooth's own frame: the height of the tip, from which depths are
/// measured.
double tipAlongAxis(const ToothAnatomy& tooth)
{
    const glm::dvec3 axis = tooth.lying.cutFromOwn() * glm::dvec3(0.0, 0.0, 1.0);
    double tip = -1.0e9;
    for (std::size_t k = 0; k < tooth.grid.count(); ++k)
        if (isSolid(tooth, k))
            tip = std::max(tip, glm::dot(axis, glm::dvec3(tooth.grid.nodeMm(k), tooth.top[k])));
    return tip;
}

std::vector<std::size_t> decayed(const ToothAnatomy& tooth)
{
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < tooth.grid.count(); ++k)
        if (isSolid(tooth, k) && tooth.layers[k].cariesRoof > tooth.layers[k].cariesFloor)
            found.push_back(k);
    return found;
}

/// Returns the mean distance of the decayed surface below the tip, along the tooth's own axis, mm.
double decayBelowTip(const ToothAnatomy& tooth)
{
    const std::vector<std::size_t> columns = decayed(tooth);
    const glm::dvec3 axis = tooth.lying.cutFromOwn() * glm::dvec3(0.0, 0.0, 1.0);
    const double tip = tipAlongAxis(tooth);
    double sum = 0.0;
    for (const std::size_t k : columns)
        sum += tip - glm::dot(axis, glm::dvec3(tooth.grid.nodeMm(k), tooth.top[k]));
    return sum / static_cast<double>(columns.size());
}

}  // namespace

class TestLaid : public QObject
{
    Q_OBJECT

private slots:
    void theNamedSideLooksUp()
    {
        for (const int fdi : {21, 26, 33, 36})
            for (const char* name : {"mesial", "distal", "buccal", "lingual"}) {
                const auto lying = teeth::findLying(name, 90.0, fdi);
                QVERIFY(support::succeeds(lying));
                QCOMPARE(std::string(teeth::nameOf(*lying, fdi)), std::string(name));
                const std::string side(name);
                const double buccal = teeth::buccalSign(fdi);
                const glm::dvec3 own = side == "mesial"   ? glm::dvec3(-1.0, 0.0, 0.0)
                                       : side == "distal" ? glm::dvec3(1.0, 0.0, 0.0)
                                                          : glm::dvec3(0.0, side == "buccal" ? buccal : -buccal, 0.0);
                QCOMPARE(lying->cutFromOwn() * own, glm::dvec3(0.0, 0.0, 1.0));
            }
        for (const char* name : {"-x", "+x", "-y", "+y"})
            QCOMPARE(std::string(teeth::nameOf(*teeth::findLying(name, 30.0, 0), 0)), std::string(name));
        QVERIFY(teeth::findLying("occlusal", 90.0, 36)->isUpright());
        QVERIFY(support::isRefused(teeth::findLying("buccal", 90.0, 0), ErrorCode::UnknownName));
        QVERIFY(support::isRefused(teeth::findLying("+x", 90.0, 36), ErrorCode::UnknownName));
        for (const double tilt : {0.0, 4.0, 91.0, std::nan("")})
            QVERIFY(support::isRefused(teeth::findLying("buccal", tilt, 36), ErrorCode::OutOfRange));
    }

    void everyTurnIsARotation()
    {
        for (const ToothSide side : {ToothSide::MinusX, ToothSide::PlusX, ToothSide::MinusY, ToothSide::PlusY})
            for (const double tilt : {5.0, 45.0, 90.0}) {
                const glm::dmat3 turn = Lying{side, tilt}.cutFromOwn();
                QVERIFY(support::near(glm::determinant(turn), 1.0));
                const glm::dmat3 square = turn * glm::transpose(turn);
                for (int c = 0; c < 3; ++c)
                    for (int r = 0; r < 3; ++r)
                        QVERIFY(support::near(square[c][r], c == r ? 1.0 : 0.0));
                QVERIFY(support::near((turn * glm::dvec3(0.0, 0.0, 1.0)).z, std::cos(tilt * support::kDegree)));
            }
        QCOMPARE(Lying{}.cutFromOwn(), glm::dmat3(1.0));
    }

    /// The columns contain the tooth and little more: seen from the side, its bulges are not undercuts.
    void theColumnsHoldTheTooth()
    {
        for (const auto& [fdi, side] : {std::pair(33, "buccal"), std::pair(22, "lingual"), std::pair(21, "mesial"),
                                        std::pair(36, "buccal"), std::pair(26, "distal")}) {
            const auto tooth = laidTooth(fdi, side);
            QVERIFY(support::succeeds(tooth));
            QVERIFY(tooth->report.undercutMm3.has_value());
            qInfo("%d %s: model %.1f mm3, undercut %.2f, cell %.3f", fdi, side, tooth->report.modelVolumeMm3,
                  *tooth->report.undercutMm3, tooth->report.cellMm);
            QVERIFY(support::between(*tooth->report.undercutMm3 / tooth->report.modelVolumeMm3, -0.005, 0.05));
            QVERIFY(tooth->report.cellMm < 0.11);
            QVERIFY(support::near(tooth->report.highMm.z, 0.0, 1.0e-4));
        }
    }

    /// On the labial side, the enamel has the thickness that belongs to the height above the neck in the tooth's own
    /// frame.
    void enamelFollowsTheTooth()
    {
        const auto tooth = laidTooth(33, "buccal");
        QVERIFY(support::succeeds(tooth));
        const ToothAnatomy& laid = *tooth->anatomy;
        const double crownMm = teeth::drawToothSizes(33, 0)->crownHeightMm;
        const glm::dvec3 axis = laid.lying.cutFromOwn() * glm::dvec3(0.0, 0.0, 1.0);
        const double tip = tipAlongAxis(laid);
        int measured = 0;
        for (std::size_t k = 0; k < laid.grid.count(); ++k) {
            const glm::dvec2 at = laid.grid.nodeMm(k);
            if (!isSolid(laid, k) || std::abs(at.x) > 0.5 * laid.grid.cellMm)
                continue;
            const double above = crownMm - (tip - glm::dot(axis, glm::dvec3(at, laid.top[k])));
            const double enamel = static_cast<double>(laid.top[k]) - std::max(static_cast<double>(laid.layers[k].dej),
                                                                              static_cast<double>(laid.bottom[k]));
            if (above < -0.3)
                QVERIFY(support::near(enamel, 0.0, 0.02));
            else if (above > 0.5 && above < 6.0) {
                QVERIFY(support::near(enamel, 0.05 + 0.16 * above, 0.2));
                ++measured;
            }
        }
        QVERIFY(measured > 40);
    }

    /// The pulp is that of the upright tooth, as far as the columns contain it.
    void thePulpIsTheSame()
    {
        for (const auto& [fdi, side] : {std::pair(33, "buccal"), std::pair(21, "lingual"), std::pair(36, "buccal")}) {
            const auto laid = laidTooth(fdi, side);
            teeth::BuildOptions upright;
            upright.caries.reset();
            const auto stood = teeth::buildTooth({fdi}, upright);
            QVERIFY(support::succeeds(laid) && support::succeeds(stood));
            const double crownMm = teeth::drawToothSizes(fdi, 0)->crownHeightMm;
            const ToothAnatomy& own = *stood->anatomy;
            double expected = 0.0;
            for (std::size_t k = 0; k < own.grid.count(); ++k)
                if (terrain::hasPulp(own, k))
                    expected +=
                        std::max(0.0, static_cast<double>(own.layers[k].pulpRoof) -
                                          std::max(static_cast<double>(own.layers[k].pulpFloor), -crownMm - 3.0)) *
                        static_cast<double>(own.areaMm2[k]);
            const double found = laid->report.layersMm3[static_cast<std::size_t>(terrain::Material::Pulp)];
            qInfo("%d %s: pulp %.2f mm3, upright %.2f", fdi, side, found, expected);
            QVERIFY(support::between(found / expected, 0.8, 1.1));
        }
    }

    void decayIsWhereItBegins_data()
    {
        QTest::addColumn<int>("fdi");
        QTest::addColumn<QString>("side");
        QTest::addColumn<int>("site");
        QTest::addColumn<double>("least");  // below the tip, as a share of the crown's height
        QTest::addColumn<double>("most");
        QTest::newRow("neck of a canine") << 33 << "buccal" << 1 << 0.75 << 1.0;
        QTest::newRow("neck of a molar") << 36 << "lingual" << 1 << 0.65 << 1.0;
        QTest::newRow("cingulum pit") << 22 << "lingual" << 2 << 0.4 << 0.85;
        QTest::newRow("buccal pit") << 36 << "buccal" << 2 << 0.25 << 0.85;
        QTest::newRow("below the contact") << 21 << "mesial" << 3 << 0.15 << 0.6;
        QTest::newRow("below the contact, lower") << 31 << "mesial" << 3 << 0.05 << 0.6;
    }

    void decayIsWhereItBegins()
    {
        QFETCH(int, fdi);
        QFETCH(QString, side);
        QFETCH(int, site);
        QFETCH(double, least);
        QFETCH(double, most);
        const double crownMm = teeth::drawToothSizes(fdi, 0)->crownHeightMm;
        double before = 0.0;
        for (const double extent : {0.3, 0.5, 0.8}) {
            const auto tooth =
                laidTooth(fdi, qPrintable(side), 90.0, extent, static_cast<LesionSite>(site), fdi == 36 ? 3U : 0U);
            QVERIFY(support::succeeds(tooth));
            const double at = decayBelowTip(*tooth->anatomy) / crownMm;
            const double volume = tooth->report.layersMm3[static_cast<std::size_t>(terrain::Material::Caries)];
            double deepest = 0.0;
            for (const std::size_t k : decayed(*tooth->anatomy)) {
                const terrain::ColumnLayers& column = tooth->anatomy->layers[k];
                deepest = std::max(deepest, static_cast<double>(tooth->anatomy->top[k] - column.cariesFloor));
                if (column.pulpRoof > column.pulpFloor)
                    QVERIFY(column.cariesFloor >= column.pulpRoof + 0.45F);
            }
            qInfo("extent %.1f: %.2f mm3, %.2f mm deep, at %.2f of the crown", extent, volume, deepest, at);
            QVERIFY(support::between(at, least, most));
            QVERIFY(volume > before);
            before = volume;
        }
    }

    void aLargerExtentContainsEverySmallerOne()
    {
        const auto small = laidTooth(33, "buccal", 90.0, 0.3);
        const auto large = laidTooth(33, "buccal", 90.0, 0.7);
        QVERIFY(support::succeeds(small) && support::succeeds(large));
        for (const std::size_t k : decayed(*small->anatomy)) {
            QVERIFY(large->anatomy->layers[k].cariesFloor <= small->anatomy->layers[k].cariesFloor);
            QVERIFY(large->anatomy->layers[k].cariesRoof >= small->anatomy->layers[k].cariesRoof);
        }
    }

    /// At 45 degrees the bur can still reach the fissures.
    void aLeaningToothHasItsFissureDecay()
    {
        const auto tooth = laidTooth(36, "buccal", 45.0, 0.6);
        QVERIFY(support::succeeds(tooth));
        QVERIFY(!decayed(*tooth->anatomy).empty());
        QVERIFY(support::between(decayBelowTip(*tooth->anatomy), 0.8, 4.0));
    }

    void whatCannotBeIsRefused()
    {
        QVERIFY(support::isRefused(laidTooth(36, "buccal", 90.0, 0.5, LesionSite::Contact), "mesial or distal side"));
        QVERIFY(support::isRefused(laidTooth(36, "mesial", 90.0, 0.5, LesionSite::Cervical), "buccal or lingual side"));
        QVERIFY(support::isRefused(laidTooth(36, "mesial", 90.0, 0.5, LesionSite::Fissure), "no fissure"));
        teeth::BuildOptions options;
        options.site = LesionSite::Pit;
        QVERIFY(support::isRefused(teeth::buildTooth({36}, options), "buccal or lingual side"));
        options = {};
        options.lying = {ToothSide::PlusY, 90.0};
        QVERIFY(
            support::isRefused(teeth::buildTooth(teeth::parseSource("block:line"), options), ErrorCode::OutOfRange));
        options.lying = {ToothSide::PlusY, 120.0};
        QVERIFY(support::isRefused(teeth::buildTooth({36}, options), ErrorCode::OutOfRange));
    }

    /// A tooth that lies on a side is not part of an arch.
    void itStandsInNoArch()
    {
        const auto tooth = laidTooth(36, "buccal");
        QVERIFY(support::succeeds(tooth));
        QVERIFY(teeth::isGenerated(*tooth->anatomy));
        QVERIFY(!teeth::standsInTheArch(*tooth->anatomy));
        QVERIFY(support::isRefused(imaging::neighboursOf(*tooth->anatomy), ErrorCode::OutOfRange));
        QVERIFY(support::isRefused(preparation::fittedDesign(preparation::Kind::ClassOne, *tooth->anatomy),
                                   ErrorCode::OutOfRange));
    }

    /// The film shows the crown with the same height and width as that of the upright tooth, whichever side it lies on.
    void theFilmShowsTheToothUpright()
    {
        const auto upright = teeth::buildTooth({33}, {});
        QVERIFY(support::succeeds(upright));
        const terrain::Tooth stood(upright->anatomy);
        const imaging::XrayedTooth one{&stood};
        for (const double angle : {90.0, 70.0}) {
            const imaging::Beam own{angle * support::kDegree, 0.0, 0.0};
            const imaging::FilmArea usual = imaging::shadowArea(std::span(&one, 1), own, 0.0);
            for (const char* side : {"buccal", "lingual", "mesial", "distal"}) {
                const auto built = laidTooth(33, side);
                QVERIFY(support::succeeds(built));
                const terrain::Tooth tooth(built->anatomy);
                const imaging::XrayedTooth laid{&tooth};
                const imaging::Beam beam = imaging::laidBeam(built->anatomy->lying, own);
                const imaging::FilmArea area = imaging::shadowArea(std::span(&laid, 1), beam, 0.0);
                // The root is shorter, so only the height of crown and neck is compared.
                QVERIFY(support::near(area.highMm.x - area.lowMm.x, usual.highMm.x - usual.lowMm.x, 0.25));
                QVERIFY(support::near(area.highMm.y - area.lowMm.y, teeth::drawToothSizes(33, 0)->crownHeightMm + 3.0,
                                      0.3));
                const imaging::Shadow shadow = imaging::castShadow(std::span(&laid, 1), beam, area, 0.1);
                // The incisal edge is narrower than the neck, so the crown must be up.
                const auto widthAt = [&](int row) {
                    int wide = 0;
                    for (int column = 0; column < shadow.width; ++column)
                        wide += shadow.at(column, row) > 0.02F ? 1 : 0;
                    return wide;
                };
                QVERIFY(widthAt(4) < widthAt(shadow.height - 10));
            }
        }
    }

    void aRecordingKeepsHowItLies()
    {
        const auto tooth = laidTooth(22, "lingual", 60.0);
        QVERIFY(support::succeeds(tooth));
        const std::string bytes = recording::toothBytes(*tooth->anatomy);
        const auto read = recording::toothFrom(bytes);
        QVERIFY(read != nullptr);
        QCOMPARE(read->lying, tooth->anatomy->lying);
        QVERIFY(terrain::isSameTooth(*read, *tooth->anatomy));
        for (const char bad : {'\0', '\5', '\x7F'}) {
            std::string wrong = bytes;
            wrong[bytes.size() - sizeof(double) - 1] = bad;
            QVERIFY(recording::toothFrom(wrong) == nullptr);
        }
        QVERIFY(recording::toothFrom(bytes.substr(0, bytes.size() - 1)) == nullptr);
        // Nothing is added for an upright tooth, so that older versions of Cusp can read the recording.
        ToothAnatomy upright = *tooth->anatomy;
        upright.lying = {};
        QCOMPARE(recording::toothBytes(upright), bytes.substr(0, bytes.size() - sizeof(double) - 1));
        QCOMPARE(recording::versionWith(upright), recording::kOldestVersion);
        QCOMPARE(recording::Recording({}, tooth->anatomy).toBytes()[8], static_cast<char>(8));
    }

    /// A scan is laid by the axes of its frame.
    void aScanIsLaidLikewise()
    {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(QStringLiteral("scan.obj")).toStdString();
        const auto mesh = teeth::generateTooth(33, 0);
        QVERIFY(support::succeeds(mesh));
        QVERIFY(mesh::writeObj(path, *mesh, "a tooth"));
        teeth::BuildOptions options;
        options.placement.unit = mesh::LengthUnit{};
        options.placement.up = mesh::parseUp("+z").value();
        options.fdi = 33;
        options.lying = *teeth::findLying("-y", 90.0, 0);
        options.site = LesionSite::Cervical;
        const auto scan = teeth::buildTooth({path}, options);
        const auto made = laidTooth(33, "buccal", 90.0, 0.5, LesionSite::Cervical);
        QVERIFY(support::succeeds(scan) && support::succeeds(made));
        QVERIFY(!teeth::isGenerated(*scan->anatomy));
        // The position of a scan's neck is estimated from the width of its crown, and with it the end of its root and
        // its decay.
        constexpr double kGuessMm = 0.5;
        QVERIFY(support::between(scan->report.modelVolumeMm3 / made->report.modelVolumeMm3, 0.95, 1.05));
        QVERIFY(support::near(decayBelowTip(*scan->anatomy), decayBelowTip(*made->anatomy), kGuessMm));
        for (std::size_t k = 0; k < scan->anatomy->grid.count(); ++k)
            QVERIFY(isSolid(*scan->anatomy, k) || scan->anatomy->layers[k] == terrain::ColumnLayers{});
    }
};

CUSP_TEST(TestLaid)
#include "tst_laid.moc"
