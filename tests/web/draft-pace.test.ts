import { describe, expect, it } from 'vitest';
import { DraftPace } from '../../web/core/draft-pace.js';
import type { EngineEvent } from '../../web/model/job.js';
import type { Stage } from '../../web/model/stages.js';

const stage = (name: Stage): EngineEvent[] => [{ type: 'stage', stage: name, progress: 0.5 }];

describe('drafts', () => {
  it('wait until every part has a net', () => {
    const pace = new DraftPace();
    pace.follow(stage('search'));
    expect(pace.isDue(1e6)).toBe(false);
    pace.follow(stage('compact'));
    expect(pace.isDue(0)).toBe(true);
  });

  it('take a twentieth of the time', () => {
    const pace = new DraftPace();
    pace.follow(stage('compact'));
    pace.made(1000, 1050);
    pace.follow(stage('compact'));
    expect(pace.isDue(2049)).toBe(false);
    expect(pace.isDue(2050)).toBe(true);
  });

  it('end when the sheets are made for good', () => {
    const pace = new DraftPace();
    pace.follow([...stage('compact'), ...stage('paper')]);
    expect(pace.isDue(1e6)).toBe(false);
  });
});
