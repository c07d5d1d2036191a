// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/bur/BurFile.h"
#include "core/bur/BurMask.h"
#include "core/contact/BurHead.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"

using namespace core;
using core::bur::Bur;

namespace {

constexpr int kSamples = 20000;

/// A tapered bur whose lines the tests change: line 3 is its material, line 5 its flat end.
const std::string kTapered = "bur mine\n"
                             "shape tapered\n"
                             "material carbide\n"
                             "neck 0.5\n"
                             "flat 0.308446\n"
                             "arc 0.408351 0.095638 0.1\n"
                             "line 0.6 4.4844\n"
                             "end\n";

/// Returns the lowest height of the written profile at a radius, along the chords of its outline.
double lowestOfOutline(const Bur& bur, double radius)
{
    double lowest = 1.0e9;
    for (std::size_t k = 1; k < bur.outline.size(); ++k) {
        const Bur::Point& a = bur.outline[k - 1];
        const Bur::Point& b = bur.outline[k];
        const double width = b.radiusMm - a.radiusMm;
        if (radius < std::min(a.radiusMm, b.radiusMm) || radius > std::max(a.radiusMm, b.radiusMm))
            continue;
        lowest =
            std::min(lowest, width == 0.0 ? std::min(a.heightMm, b.heightMm)
                                          : a.heightMm + (b.heightMm - a.heightMm) * (radius - a.radiusMm) / width);
    }
    return lowest;
}

/// Formats a number with at least one and at most two decimals: "3.8", "0.92".
QString decimals(double value)
{
    QString text = QString::number(value, 'f', 2);
    if (text.endsWith('0'))
        text.chop(1);
    return text;
}

/// Describes the side of a bur as the table in docs/burs.md does: "ball", "upright", "opens by 2.5° a side".
QString sideOf(const Bur& bur)
{
    const auto degrees = [](double run, double rise) {
        const double halves = std::round(2.0 * std::atan2(run, rise) / support::kDegree);
        return QString::number(0.5 * halves) + "° a side";
    };
    if (bur.shape == bur::BurShape::Round)
        return "ball";
    if (bur.hasCone())
        return "opens by " + degrees(1.0, bur.coneSlope);
    const Bur::Point& last = bur.outline.back();
    const Bur::Point& before = bur.outline[bur.outline.size() - 2];
    return last.radiusMm < before.radiusMm
               ? "closes by " + degrees(before.radiusMm - last.radiusMm, last.heightMm - before.heightMm)
               : QString("upright");
}

/// Returns the bur's row in the table of docs/burs.md.
std::string rowOf(const Bur& bur)
{
    const QString shape = QString::fromStdString(std::string(bur::shapeWord(bur.shape))).replace('-', ' ');
    const QString end =
        (bur.hasFlatEnd() ? "flat, edge " : "round ") + QString::number(std::round(100.0 * bur.cornerMm) / 100.0);
    const QString material = bur.isDiamond() ? QString("diamond") : QString("carbide");
    const QStringList cells{QString::fromStdString(bur.id),
                            shape,
                            material,
                            QString::fromStdString(bur.isoSize()),
                            QString::number(2.0 * bur.headRadiusMm, 'f', 1),
                            decimals(bur.headLengthMm),
                            end,
                            sideOf(bur),
                            QString::fromStdString(bur.iso6360)};
    return ("| " + cells.join(" | ") + " |").toStdString();
}

std::string with(std::size_t line, const std::string& text)
{
    std::string changed;
    std::size_t number = 0;
    std::size_t from = 0;
    while (from < kTapered.size()) {
        const std::size_t end = kTapered.find('\n', from) + 1;
        changed += ++number == line ? text : kTapered.substr(from, end - from);
        from = end;
    }
    return changed;
}

}  // namespace

class TestBur : public QObject
{
    Q_OBJECT
private slots:
    void allBurs_data()
    {
        QTest::addColumn<std::size_t>("index");
        for (std::size_t k = 0; k < core::bur::burs().size(); ++k)
            QTest::newRow(core::bur::burs()[k].id.c_str()) << k;
    }

    /// Recordings refer to burs by index and must replay to the bit.
    void theFirstFourStayAsTheyAre()
    {
        const auto burs = core::bur::burs();
        QVERIFY(burs.size() >= 24);
        const auto is = [&](std::size_t k, const char* id, double radius, double length, double neck, double corner,
                            std::size_t points) {
            const Bur& bur = burs[k];
            return bur.id == id && bur.headRadiusMm == radius && bur.headLengthMm == length &&
                   bur.shankRadiusMm == neck && bur.cornerMm == corner && bur.flatRadiusMm() == radius - corner &&
                   !bur.hasCone() && bur.outline.size() == points;
        };
        QVERIFY(is(0, "2", 0.5, 0.9249880977778621, 0.25, 0.5, 54));
        QVERIFY(is(1, "330", 0.4, 1.6, 0.4 - 0.14054 * (1.6 - 0.25), 0.25, 35));
        QVERIFY(is(2, "245", 0.4, 3.0, 0.4 - 0.06993 * (3.0 - 0.2), 0.2, 35));
        QVERIFY(is(3, "57", 0.5, 3.8, 0.4, 0.1, 35));
    }

    /// A recording stores the place of a bur in the list. Append a new bur behind these; it needs no entry here.
    void bursThatExistKeepTheirPlaces()
    {
        constexpr std::array kPlaces{"2",   "330", "245", "57",  "1/4", "1/2", "1",    "4",    "6",   "8",   "33-1/2",
                                     "34",  "35",  "56",  "58",  "556", "557", "1557", "169L", "170", "171", "271",
                                     "701", "329", "331", "801", "836", "856", "877",  "830",  "379", "860"};
        const auto burs = bur::burs();
        QVERIFY2(burs.size() >= kPlaces.size(), "A bur of core/bur/burs.txt was removed; old recordings need it.");
        for (std::size_t k = 0; k < kPlaces.size(); ++k)
            QVERIFY2(burs[k].id == kPlaces[k],
                     qPrintable(QString("Bur %1 of core/bur/burs.txt must be %2. Old recordings name burs by their "
                                        "place: append new ones at the end.")
                                    .arg(k + 1)
                                    .arg(kPlaces[k])));
        // There is room for one more bur, from a user's file.
        QVERIFY(burs.size() < bur::kMostBurs);
    }

    void documentsListTheBurs()
    {
        std::vector<std::string> ids;
        std::string rows;
        for (const Bur& bur : bur::burs()) {
            ids.push_back(bur.id);
            rows += (rows.empty() ? "" : "\n") + rowOf(bur);
        }
        QVERIFY(support::isSchemaUpToDate("bur", ids));
        QVERIFY(support::isListUpToDate("docs/burs.md", "|---|---|---|---|---|---|---|---|---|\n", "\n\n", rows));
    }

    void everyBurHasItsSizes()
    {
        std::set<std::string> ids;
        for (const Bur& bur : core::bur::burs()) {
            QVERIFY2(ids.insert(bur.id).second, bur.id.c_str());
            QCOMPARE(bur.isoSize().size(), 3U);
            if (!bur.iso6360.empty())
                QVERIFY2(bur.iso6360.ends_with(bur.isoSize()), bur.id.c_str());
            for (std::size_t k = 1; k < bur.outline.size(); ++k)
                QVERIFY2(bur.outline[k].heightMm >= bur.outline[k - 1].heightMm, bur.id.c_str());
        }
        QCOMPARE(core::bur::burs()[core::bur::findBur("1/4").value()].isoSize(), std::string("005"));
        QCOMPARE(core::bur::burs()[core::bur::findBur("8").value()].isoSize(), std::string("023"));
    }

    void theUndersideIsTheProfile_data() { allBurs_data(); }

    void theUndersideIsTheProfile()
    {
        QFETCH(std::size_t, index);
        const Bur& bur = core::bur::burs()[index];
        double before = 0.0;
        for (int k = 0; k < kSamples; ++k) {
            const double radius = bur.headRadiusMm * k / kSamples;
            const double height = bur.undersideMm(radius);
            QVERIFY2(height >= before, "it never falls");
            const double chord = lowestOfOutline(bur, radius);
            // A chord of an arc is inside the head, at most this far from the arc.
            const double apart = 4.0e-4 * bur.cornerMm + 1.0e-6;
            const double inside = bur.undersideMm(std::min(bur.headRadiusMm, radius + apart)) + apart;
            QVERIFY2(chord > height - 1.0e-6 && chord < inside,
                     qPrintable(QString("at %1: %2, not %3").arg(radius).arg(chord, 0, 'g', 9).arg(height, 0, 'g', 9)));
            before = height;
        }
    }

    void theMaskIsTheSlowObviousSearch_data() { allBurs_data(); }

    /// Compares the height of the bur on a slope, its reach at a height and its steepness there with a dense sampling
    /// of the underside.
    void theMaskIsTheSlowObviousSearch()
    {
        QFETCH(std::size_t, index);
        const Bur& bur = core::bur::burs()[index];
        const core::bur::BurMask mask(bur, 0.07);
        const double step = bur.headRadiusMm / kSamples;
        for (const double slope : {0.0, 0.05, 0.3, 1.0, 1.8, 3.0, 4.5, 8.0, 18.0, 25.0, 40.0, 300.0}) {
            double most = -1.0e9;
            for (int k = 0; k <= kSamples; ++k)
                most = std::max(most, slope * step * k - bur.undersideMm(step * k));
            const double stands = mask.standsAt(slope);
            QVERIFY(stands <= static_cast<double>(mask.radiusMm));
            const double there = slope * stands - mask.heightAt(stands);
            QVERIFY2(std::abs(there - most) < 1.0e-6 + 2.0 * slope * step,
                     qPrintable(QString("slope %1: %2, not %3").arg(slope).arg(there).arg(most)));
        }
        for (double height = 0.0; height < bur.headLengthMm; height += 0.013) {
            double reach = 0.0;
            for (int k = 0; k <= kSamples && bur.undersideMm(step * k) <= height; ++k)
                reach = step * k;
            QVERIFY2(std::abs(mask.reachAt(height) - reach) < 2.0 * step, qPrintable(QString::number(height)));
        }
        for (int k = 1; k < kSamples; ++k) {
            const double radius = step * k;
            QVERIFY(std::abs(mask.heightAt(radius) - bur.undersideMm(radius)) < 1.0e-12);
            const double before = (bur.undersideMm(radius) - bur.undersideMm(radius - step)) / step;
            const double behind =
                (bur.undersideMm(std::min(bur.headRadiusMm, radius + step)) - bur.undersideMm(radius)) / step;
            const double slope = mask.slopeAt(radius);
            QVERIFY2(slope >= before - 1.0e-6 && slope <= behind + 1.0e-6,
                     qPrintable(QString("at %1: %2 to %3, not %4").arg(radius).arg(before).arg(behind).arg(slope)));
        }
    }

    void whatCutsIsTheProfile_data() { allBurs_data(); }

    /// The heights that contact and cutting compute in single precision are on the profile.
    void whatCutsIsTheProfile()
    {
        QFETCH(std::size_t, index);
        const Bur& bur = core::bur::burs()[index];
        const core::bur::BurMask mask(bur, 0.07);
        const contact::BurHead head = contact::headAt(mask, 0.07, 0.0, 0.0);
        float before = 0.0F;
        for (int k = 0; k <= kSamples; ++k) {
            const double radius = bur.headRadiusMm * k / kSamples;
            const auto r2 = static_cast<float>(radius * radius);
            if (!(r2 <= head.radius2))
                continue;
            const float under = contact::underAt(r2, head);
            QVERIFY2(under >= before, "it never falls");
            before = under;
            // Where the side is steep, the smallest step of a float radius is a larger step in height.
            const double low = bur.undersideMm(std::max(0.0, radius - 2.0e-7));
            const double high = bur.undersideMm(std::min(bur.headRadiusMm, radius + 2.0e-7));
            QVERIFY2(under > low - 2.0e-6 && under < high + 2.0e-6,
                     qPrintable(QString("at %1: %2, not %3 to %4").arg(radius).arg(under).arg(low).arg(high)));
        }
        QCOMPARE(contact::underAt(head.radius2 * 1.001F, head), core::bur::BurMask::kAbsent);
    }

    void readsAUsersBur()
    {
        const auto burs = core::bur::parseBurs("# mine\r\n\r\n" + kTapered);
        QVERIFY2(burs, burs ? "" : burs.error().detail.c_str());
        QCOMPARE(burs->size(), 1U);
        const Bur& bur = burs->front();
        QVERIFY(bur.hasCone() && !bur.isDiamond());
        QCOMPARE(bur.isoSize(), std::string("012"));
        // 2.5 degrees a side.
        QVERIFY(std::abs(1.0 / bur.coneSlope - std::tan(2.5 * 0.017453292519943295)) < 1.0e-4);
        QVERIFY(core::bur::parseBurs(with(3, "material diamond 524\niso6360 806 314 168 524 012 # a cone\n"))
                    ->front()
                    .grit == 524);
    }

    void refusesWhatIsNoBur_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const std::string& text, const char* says) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(says);
        };
        row("nothing", "", "no bur");
        row("binary",
            std::string("\x7f"
                        "ELF\0\1\2",
                        7),
            "not plain text");
        row("an umlaut", with(4, "neck 0.5 \xC3\xBC\n"), "Line 4 of the bur file: only a comment");
        row("crosses itself", with(7, "line 0.6 4.4844\nline 0.2 0.05\nline 0.55 0.5\n"),
            "Line 9 of the bur file: the profile crosses itself");
        row("negative", with(5, "flat -0.3\n"), "Line 5 of the bur file: a radius or a height is negative");
        row("too wide", with(7, "line 2.6 4.4844\n"), "Line 7 of the bur file: a head has at most 1.5 mm");
        row("too long", with(7, "line 0.6 9\n"), "Line 7 of the bur file: a head has at most 1.5 mm");
        row("too thin", "bur a\nshape round\nmaterial carbide\nneck 0.05\narc 0.1 0.1 0.1\nend\n",
            "Line 5 of the bur file: a head has at least 0.2 mm");
        row("too sharp", with(6, "arc 0.308456 0.000001 0.00001\n"), "Line 6 of the bur file: an edge is rounded");
        row("arc off the end", with(5, "flat 0.2\n"), "Line 6 of the bur file: the arc is not tangent to the flat end");
        row("line off the arc", with(7, "line 0.9 1\n"), "Line 7 of the bur file: the line is not tangent");
        row("no arc", with(6, ""), "Line 6 of the bur file: a profile begins with an arc");
        row("only a flat", with(6, "").substr(0, kTapered.find("arc")) + "end\n",
            "Line 5 of the bur file: a profile begins with an arc");
        row("open arc", with(7, ""), "Line 6 of the bur file: the arc ends neither upright");
        row("outwards again", with(7, "line 0.6 4.4844\nline 0.5 5\nline 0.55 6\n"),
            "Line 9 of the bur file: past the largest radius");
        row("down again", with(7, "line 0.6 4.4844\nline 0.58 2\n"), "Line 8 of the bur file: past the largest radius");
        row("flat again", with(7, "line 0.6 4.4844\nflat 0.2\n"), "Line 8 of the bur file");
        row("bent arc above", with(7, "line 0.6 4.4844\narc 0.5 5 9\n"),
            "Line 8 of the bur file: the arc does not begin upright");
        row("thick neck", with(4, "neck 0.7\n"), "Line 8 of the bur file: the neck is thicker");
        row("truncated", kTapered.substr(0, kTapered.size() - 5), "Line 7 of the bur file: the text ends within a bur");
        row("within a number", kTapered.substr(0, kTapered.find("4.4844") + 1), "ends within a bur");
        row("no end", kTapered.substr(0, kTapered.size() - 4) + kTapered,
            "Line 8 of the bur file: the bur before it has no");
        row("no number", with(4, "neck thin\n"), "Line 4 of the bur file: the radius of the neck");
        row("not finite", with(5, "flat nan\n"), "Line 5 of the bur file: 'flat' has 1 numbers");
        row("too few numbers", with(6, "arc 0.4 0.1\n"), "Line 6 of the bur file: 'arc' has 3 numbers");
        row("one word more", with(5, "flat 0.308446 7\n"), "Line 5 of the bur file: '7' is one word too many");
        row("no such shape", with(2, "shape cubic\n"), "Line 2 of the bur file: there is no shape 'cubic'");
        row("no such material", with(3, "material wood\n"), "Line 3 of the bur file: the material");
        row("no grit", with(3, "material diamond\n"), "Line 3 of the bur file: the material");
        row("no such key", with(4, "colour red\n"), "Line 4 of the bur file: there is nothing called 'colour'");
        row("no material", with(3, ""), "Line 7 of the bur file: the bur lacks");
        row("no number of ISO 6360", with(4, "iso6360 1 2 3\n"), "Line 4 of the bur file: a number of ISO 6360");
        row("twice", kTapered + kTapered, "Line 9 of the bur file: there is a bur 'mine' already");
        row("long name", "bur abcdefghijklmnopqrstuvwxyz\n", "Line 1 of the bur file: a bur is called");
        row("many elements",
            with(7,
                 [] {
                     std::string many;
                     for (int k = 0; k < 40; ++k)
                         many += "line 0.6 4\n";
                     return many;
                 }()),
            "a profile has at most 16 elements");
    }

    void refusesWhatIsNoBur()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, says);
        const auto burs = core::bur::parseBurs(text.toStdString());
        QVERIFY(!burs);
        QVERIFY2(burs.error().detail.find(says.toStdString()) != std::string::npos, burs.error().detail.c_str());
        QVERIFY(burs.error().detail.ends_with('.') && burs.error().detail.find('\n') == std::string::npos);
    }

    void readsWhatEditorsAdd()
    {
        const auto plain = core::bur::parseBurs(kTapered);
        const std::string other = "\xEF\xBB\xBF# f\xC3\xBCr Stufen\r\n" + kTapered;
        const auto read = core::bur::parseBurs(other);
        QVERIFY(support::succeeds(plain) && support::succeeds(read));
        QCOMPARE(read->front().headRadiusMm, plain->front().headRadiusMm);
    }

    void readsAFile()
    {
        const QTemporaryDir dir;
        const std::filesystem::path file = dir.filePath("mine.txt").toStdString();
        QCOMPARE(core::bur::readBur(file).error().code, ErrorCode::FileMissing);
        QCOMPARE(core::bur::readBur(dir.path().toStdString()).error().code, ErrorCode::FileUnreadable);
        const auto write = [&](const std::string& text) {
            QFile out(QString::fromStdString(file.string()));
            return out.open(QIODevice::WriteOnly) &&
                   out.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
        };
        QVERIFY(write(kTapered));
        QCOMPARE(core::bur::readBur(file)->id, std::string("mine"));
        QVERIFY(write(std::string(70000, '#')));
        QCOMPARE(core::bur::readBur(file).error().code, ErrorCode::FileTooLarge);
        QVERIFY(write(kTapered + "bur other" + kTapered.substr(8)));
        QCOMPARE(core::bur::readBur(file).error().code, ErrorCode::BadStructure);
    }
};

CUSP_TEST(TestBur)
#include "tst_bur.moc"
