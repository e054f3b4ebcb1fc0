// SPDX-License-Identifier: MIT
#include "lixel/plan/technique.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

namespace lixel {
namespace {

std::string canonical(std::string_view text)
{
    const auto technique = parseTechnique(text);
    return technique ? toString(*technique) : technique.error();
}

TEST(TechniqueText, PartsLeftOutTakeTheirDefaultAndOrderIsFree)
{
    EXPECT_EQ(canonical("focused"), "whole+focused+depths(1)+pcf(1)");
    EXPECT_EQ(canonical("pcf(9)"), "whole+focused+depths(1)+pcf(9)");
    EXPECT_EQ(canonical("pcf(9)+uniform"), canonical("uniform + pcf(9)"));
    EXPECT_EQ(canonical("exact-area"), "exact-area(64)");
    EXPECT_EQ(canonical("exact-filtered"), "exact-filtered(whole+focused+depths(1)+pcf(1),rays=256)");
    EXPECT_EQ(canonical("exact-filtered(pcf(9), rays=64)"), "exact-filtered(whole+focused+depths(1)+pcf(9),rays=64)");
    EXPECT_EQ(canonical("sdsm"), "sdsm(4)+desired-view+allocation=need+depths(1)+pcf(1)");
    EXPECT_EQ(canonical("pssm:2+lispsm"), "pssm(2,lambda=0.5)+lispsm+allocation=need+depths(1)+pcf(1)");
    EXPECT_EQ(canonical("psm+else(cube)"),
              "whole+psm(shift=casters)+else(cube+focused)+allocation=need+depths(1)+pcf(1)");
}

TEST(TechniqueText, ALookupIsAStoreAKernelAndRefinements)
{
    EXPECT_EQ(canonical("depths(2)"), "whole+focused+depths(2,max,q=9,bits=32)+pcf(1)");
    EXPECT_EQ(canonical("depths(3)+pcf(9,rotated)"), "whole+focused+depths(3,minmax,q=9,bits=32)+pcf(9,rotated)");
    EXPECT_EQ(canonical("depths(7)"), "whole+focused+depths(7,sorted,q=9,bits=16)+pcf(1)");
    EXPECT_EQ(canonical("dual-plane+bilinear"), "whole+focused+depths(1)+bilinear+dual-plane");
    EXPECT_EQ(canonical("msm"), "whole+focused+msm(blur=3)+pcf(1)");
}

TEST(TechniqueText, StableIsTheTechniquesWhereverItStands)
{
    EXPECT_EQ(canonical("pssm(4,stable)"), canonical("pssm(4)+focused(stable)"));
    EXPECT_EQ(canonical("sdsm(4,stable)"), "sdsm(4)+focused(stable)+allocation=share+depths(1)+pcf(1)");
    EXPECT_EQ(canonical("lispsm(stable)"), "whole+lispsm(stable)+depths(1)+pcf(1)");
}

TEST(TechniqueText, ColonsStandForParenthesesAndKeysForPositions)
{
    EXPECT_EQ(canonical("pcf:16"), canonical("pcf(16)"));
    EXPECT_EQ(canonical("pcf(k=16)"), canonical("pcf( 16 )"));
    EXPECT_EQ(canonical("exact-area:4"), "exact-area(4)");
}

TEST(TechniqueText, TheCanonicalFormParsesBackToTheSameValue)
{
    for (const char* text : {"focused",
                             "uniform+pcf(25)",
                             "whole+uniform",
                             "exact",
                             "exact-area(16)",
                             "shadow-volumes",
                             "exact-filtered(pcf:9)",
                             "exact-filtered(rays=16,pssm(2,lambda=1)+allocation=share+depths(3,q=25)+pcf(4))",
                             "exact-filtered(now(importance=count,power=1)+msm(5),rays=4)",
                             "pcf:4",
                             "sdsm:3",
                             "cube+desired-view(rotated)",
                             "dual-paraboloid",
                             "dual-paraboloid(raster=vertices)+uniform+pcf(9)",
                             "dual-paraboloid+desired-view+now(raster=tessellate)",
                             "tsm(focus=2.5)+else(pssm(3,lambda=0.7)+lispsm)+allocation=share",
                             "matrix(a b.json)",
                             "plan(x.json)",
                             "pssm(16,stable,lambda=1)+pcf",
                             "sdsm(2,stable)",
                             "psm(shift=none)",
                             "planes:floor:wall",
                             "planes(floor,wall,twist=line)+plane-optimal(desired-view)+else(pssm(2))",
                             "planes(auto)",
                             "planes(auto,twist=none)+else(focused)",
                             "planes(floor)+plane-optimal(uncovered=lit)",
                             "planes(auto)+plane-optimal(uncovered=lit)",
                             "rtw",
                             "cube+lispsm+now(power=0.5,lines=nearest)",
                             "now(importance=count*distance*max(edges,boundaries),smooth=1/8,grid=64)",
                             "rtw(importance=shadow-edges,analysis=forward,raster=vertices)",
                             "scene-optimal+now",
                             "paper:now",
                             "paper:rtw+pcf(9)",
                             "planes(floor,my wall)+allocation=exact+pcf(9)",
                             "depths(2)",
                             "exact-filtered(pcf(9,rotated))",
                             "depths(2,min,q=25)+pcf(9,rotated)",
                             "depths:3",
                             "depths(4,bits=16)+bilinear+dual-plane",
                             "depths(8,sorted)+pcf(jittered)",
                             "fast-pcf+pcf(4)+dual-plane",
                             "hardware-pcf+lispsm",
                             "vsm",
                             "evsm2(5)",
                             "evsm4(blur=1)",
                             "msm:7"}) {
        const Technique technique = *parseTechnique(text);
        EXPECT_EQ(*parseTechnique(toString(technique)), technique) << text;
    }
}

TEST(TechniqueText, WhatIsWrongIsOneLineThatQuotesIt)
{
    for (const char* text : {"",
                             "nosuch",
                             "focused+uniform",
                             "pcf(3)",
                             "pcf(9",
                             "pcf)9(",
                             "pcf(1,2)",
                             "exact+focused",
                             "focused(2)",
                             "+",
                             "depths(0)",
                             "depths(9)",
                             "depths(max)",
                             "depths(1,max)",
                             "depths(2,minmax)",
                             "depths(2,max,min)",
                             "depths(3,max)",
                             "depths(4,min)",
                             "depths(2,q=16)",
                             "depths(3,bits=16)",
                             "depths(5,bits=32)",
                             "pcf(4,rotated,jittered)",
                             "pcf(4)+bilinear",
                             "bilinear(2)",
                             "dual-plane+dual-plane",
                             "vsm+evsm2",
                             "vsm+depths(2)",
                             "vsm(blur=4)",
                             "msm(blur=17)",
                             "vsm+pcf(4)",
                             "msm+dual-plane",
                             "depths(2)+hardware-pcf",
                             "hardware-pcf+dual-plane",
                             "fast-pcf+bilinear",
                             "exact+dual-plane",
                             "pcf(k=)",
                             "pcf(n=4)",
                             "exact-area(0)",
                             "exact-area(99999999999999999999)",
                             "exact-area(4,9)",
                             "exact-filtered(nosuch)",
                             "exact-filtered(exact)",
                             "exact-filtered(exact-area(4))",
                             "exact-filtered(exact-filtered(focused))",
                             "exact-filtered(focused,uniform)",
                             "exact-filtered(focused,rays=3)",
                             "exact-filtered(focused,rays=0)",
                             "exact-filtered(bilinear)",
                             "exact-filtered()",
                             "exact-filtered+focused",
                             "exact+exact-filtered",
                             "pcf()",
                             "pssm(0)",
                             "pssm(17)",
                             "pssm(2,lambda=2)",
                             "sdsm(2,lambda=1)",
                             "tsm(focus=0)",
                             "psm(shift=back)",
                             "matrix()",
                             "cube(3)",
                             "dual-paraboloid(2)",
                             "dual-paraboloid(raster=best)",
                             "dual-paraboloid+cube",
                             "dual-paraboloid+lispsm",
                             "dual-paraboloid+desired-view(rotated)",
                             "dual-paraboloid+focused(stable)",
                             "dual-paraboloid+else(focused)",
                             "focused+else(dual-paraboloid)",
                             "dual-paraboloid(raster=exact)+now",
                             "dual-paraboloid+now(analysis=forward)",
                             "uniform(stable)",
                             "pssm(2)+lispsm(stable)",
                             "sdsm(2,stable)+desired-view",
                             "tsm+focused(stable)",
                             "allocation=need",
                             "planes",
                             "planes()",
                             "planes(floor,auto)",
                             "planes(floor,floor)",
                             "planes(floor,twist=loose)",
                             "planes(floor,twist=line,twist=none)",
                             "planes(a,b,c,d,e,f,g,h,i)",
                             "plane-optimal",
                             "planes(floor)+plane-optimal(uncovered=dark)",
                             "planes(floor)+plane-optimal(uncovered=lit)+else(focused)",
                             "planes(floor)+focused(stable)",
                             "planes(floor)+else(planes(wall))",
                             "pssm(2)+allocation=exact",
                             "rtw+now",
                             "rtw(lines=nearest)",
                             "now(power=2)",
                             "now(power=2/0)",
                             "now(grid=4)",
                             "now(importance=)",
                             "now(importance=count*count)",
                             "now(importance=max(edges,edges))",
                             "now(importance=shadow-edges)",
                             "now(raster=best)",
                             "focused(stable)+now",
                             "planes(floor)+allocation=exact+now",
                             "matrix(a.json)+rtw",
                             "paper:nosuch",
                             "paper:now+uniform",
                             "planes(floor)+focused+allocation=exact",
                             "pssm(2,stable)+allocation=need",
                             "pssm(2)+allocation=most",
                             "else(focused",
                             "else()",
                             "focused+else(pcf(4))",
                             "focused+else(focused(stable))",
                             "pssm(2)+matrix(f.json)",
                             "focused+else(matrix(f.json))",
                             "cube+pssm(2)",
                             "plan(f.json)+allocation=need"}) {
        const auto technique = parseTechnique(text);
        ASSERT_FALSE(technique) << text;
        EXPECT_NE(technique.error().find(text), std::string::npos);
        EXPECT_EQ(technique.error().find('\n'), std::string::npos);
    }
}

TEST(TechniqueText, ListsSplitAtCommasOutsideParenthesesOnly)
{
    EXPECT_EQ(*splitTechniques("focused,depths(1,max), pcf(9)"),
              (std::vector<std::string>{"focused", "depths(1,max)", "pcf(9)"}));
    EXPECT_FALSE(splitTechniques("focused,,exact"));
    EXPECT_FALSE(splitTechniques("focused,(exact"));
}

TEST(TechniqueText, RandomTextNeverCrashes)
{
    test::forEachCase(test::kCases, [](test::Rng& rng) {
        static constexpr std::string_view kPieces[] = {"focused", "pcf", "(", ")", ":", ",",     "+",
                                                       "=",       " ",   "9", "k", "-", "exact", "\xff"};
        std::string text;
        for (int i = rng.integer(0, 12); i > 0; --i) text += kPieces[std::size_t(rng.integer(0, 13))];
        if (const auto technique = parseTechnique(text)) {
            EXPECT_EQ(*parseTechnique(toString(*technique)), *technique) << text;
        }
        (void)splitTechniques(text);
    });
}

} // namespace
} // namespace lixel
