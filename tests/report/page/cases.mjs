import {readFileSync} from "node:fs";

/// What page_cases.cpp has written; the environment variable PAGE_CASES names its file.
export const cases = JSON.parse(readFileSync(process.env.PAGE_CASES, "utf8"));
